"""What one trip turns into heat: from the simulation of the drive, or from its motor side running down (V1)."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal, NamedTuple

from ...arrays import Values
from ...engines import setting
from ...engines.protocol import Clutch
from ...equations import heat as law
from ...equations import overload
from ...errors import Problem, SpecError
from ...messages import say
from ...spec.drive import Drive
from ...spec.heat import missing_of

if TYPE_CHECKING:
    from ..answers import Answers

EnergySource = Literal["simulate", "run-down", "constant-speed"]
ENDS = ("min", "mean", "max")


class Trip(NamedTuple):
    """A slip at one friction; a time and an energy of None: it does not end."""

    torque: Values
    time: Values | None
    energy: Values | None
    carried: bool = False
    """Whether the motor can carry the slip torque, so that only a cut-off ends it."""


def trips(clutch: Clutch, answers: "Answers | None" = None) -> tuple[EnergySource, Mapping[str, Trip]]:
    """Heat and time of a trip at f_min, mean and f_max.

    Args:
        clutch: the clutch; the [drive] block of its spec says what drives it.
        answers: what was asked of it already.

    Returns:
        Where the energy is from, and the trips.

    Raises:
        SpecError: the [drive] block says too little.
    """
    drive = clutch.spec.drive
    if missing := missing_of(drive):
        problems = [Problem(f"drive.{key}", None, say("required by heat (or give drive.event)")) for key in missing]
        raise SpecError(clutch.spec.label, problems)
    motor = motor_torque(clutch)
    return (
        "run-down" if drive.motor_inertia is not None else "constant-speed",
        {end: _run_down(drive, _torque(clutch, end), motor) for end in ENDS},
    )


def motor_torque(clutch: Clutch) -> Values:
    """M_1, N·m: as given, else the load before the trip, else the machine's nominal torque."""
    drive = clutch.spec.drive
    given = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    if given is not None:
        return given
    margin = clutch.spec.adjustment.margin / setting.margin(clutch.spec)
    machine: Values = overload.machine_torque(clutch.nominal_torque, margin)
    return machine


def _torque(clutch: Clutch, end: str) -> Values:
    torque: Values = clutch.torque(*(getattr(own, end) for own in clutch.friction))
    return torque


def _run_down(drive: Drive, torque: Values, motor: Values) -> Trip:
    """V1 until the motor side stands or is switched off; switched off it runs down against the clutch alone."""
    speed, inertia, off = drive.speed, drive.motor_inertia, drive.cut_off
    assert speed is not None
    if inertia is None:
        assert off is not None
        return Trip(torque, off, law.slip_energy(torque, speed, speed, off), carried=True)
    carried = bool(torque <= motor)
    if not carried:
        time = law.run_down_time(inertia, speed, torque, motor)
        if off is None or time <= off:
            return Trip(torque, time, law.run_down_energy(inertia, speed, torque, motor))
    if off is None:
        return Trip(torque, None, None, carried)
    # a motor that can carry the slip torque goes on at its speed
    end = speed if carried else law.speed_after(speed, inertia, torque, motor, off)
    until = law.slip_energy(torque, speed, end, off)
    after = law.run_down_time(inertia, end, torque, 0.0), law.run_down_energy(inertia, end, torque, 0.0)
    return Trip(torque, off + after[0], until + after[1], carried)
