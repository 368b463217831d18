"""The drive around a clutch: the [drive] block of a spec."""

from .fields import Block, Coefficient, Inertia, Speed, Time, TorqueOrNone, key_field


class Drive(Block):
    """The drive around the clutch."""

    dynamic_factor: Coefficient = key_field("dynamic factor of the unprotected side", "k_д", default=1.0)
    speed: Speed | None = key_field("speed of the motor side before the trip", "ω_0")
    motor_inertia: Inertia | None = key_field("moment of inertia of the motor side, driving half included", "J_1")
    load_torque: TorqueOrNone | None = key_field("torque before the trip; default T_н.маш", "T_0")
    motor_torque: TorqueOrNone | None = key_field("torque of the motor; default load_torque", "M_1")
    cut_off: Time | None = key_field("slip until the motor is switched off; absent: never", "t_off")
