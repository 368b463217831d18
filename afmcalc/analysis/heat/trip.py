"""What one trip turns into heat: from the simulation of the drive, or from its motor side running down (V1)."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal, NamedTuple

from ...arrays import Values
from ...engines.protocol import Clutch
from ...equations import heat as law
from ...errors import Problem, SpecError
from ...findings import Finding
from ...messages import say
from ...spec.drive import Drive
from ...spec.heat import missing_of
from ..registry import ANALYSES

if TYPE_CHECKING:
    from ..answers import Answers

EnergySource = Literal["simulate", "run-down", "constant-speed"]
ENDS = ("min", "mean", "max")


class HeatedSlip(NamedTuple):
    """A slip at one friction; a time and an energy of None: it does not end."""

    torque: Values
    time: Values | None
    energy: Values | None
    carried: bool = False
    """Whether the motor can carry the slip torque, so that only a cut-off ends it."""


class HeatedSlips(NamedTuple):
    """The trip at f_min, mean and f_max, and where its heat is from."""

    source: EnergySource
    speed: Values
    """Of the motor side before it, rad/s."""
    at: Mapping[str, HeatedSlip]
    found: tuple[Finding, ...] = ()
    """What the simulation says of the end of the slip."""


def trips(clutch: Clutch, answers: "Answers | None" = None) -> HeatedSlips:
    """Heat and time of a trip at f_min, mean and f_max.

    An event of the [drive] block is simulated; without one the tool is blocked (V1).

    Args:
        clutch: the clutch; the [drive] block of its spec says what drives it.
        answers: what was asked of it already.

    Raises:
        SpecError: the [drive] block says too little.
        AfmcalcError: there is an event, and SciPy is missing: another way would give other digits.
    """
    drive = clutch.spec.drive
    if ANALYSES["simulate"].applies(clutch):
        return _simulated(clutch, answers)
    if missing := missing_of(drive):
        problems = [Problem(f"drive.{key}", None, say("required by heat (or give drive.event)")) for key in missing]
        raise SpecError(clutch.spec.label, problems)
    assert drive.speed is not None
    source: EnergySource = "constant-speed" if drive.motor_inertia is None else "run-down"
    motor = motor_torque(clutch)
    return HeatedSlips(source, drive.speed, {end: _run_down(drive, _torque(clutch, end), motor) for end in ENDS})


def motor_torque(clutch: Clutch) -> Values:
    """M_1, N·m: as given, else the load before the trip, else the machine's nominal torque."""
    drive = clutch.spec.drive
    given = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    return clutch.machine_torque if given is None else given


def _simulated(clutch: Clutch, answers: "Answers | None") -> HeatedSlips:
    from ..simulate.simulate import simulate
    from ..simulate.train import train_of

    found, said = simulate(clutch) if answers is None else answers.ask("simulate")
    told = found.sliding_torque, found.slip_time, found.slip_energy
    at = {end: HeatedSlip(*(getattr(each, end) for each in told)) for end in ENDS}
    ends = tuple(each for each in said if each.path in ("drive.cut_off", "drive.event.duration"))
    return HeatedSlips("simulate", train_of(clutch).speed, at, ends)


def _torque(clutch: Clutch, end: str) -> Values:
    torque: Values = clutch.torque(*(getattr(own, end) for own in clutch.friction))
    return torque


def _run_down(drive: Drive, torque: Values, motor: Values) -> HeatedSlip:
    """V1 until the motor side stands or is switched off; switched off it runs down against the clutch alone."""
    speed, inertia, off = drive.speed, drive.motor_inertia, drive.cut_off
    assert speed is not None
    if inertia is None:
        assert off is not None
        return HeatedSlip(torque, off, law.slip_energy(torque, speed, speed, off))
    carried = bool(torque <= motor)
    if not carried:
        time = law.run_down_time(inertia, speed, torque, motor)
        if off is None or time <= off:
            return HeatedSlip(torque, time, law.run_down_energy(inertia, speed, torque, motor))
    if off is None:
        return HeatedSlip(torque, None, None, carried)
    # a motor that can carry the slip torque goes on at its speed
    end = speed if carried else law.speed_after(speed, inertia, torque, motor, off)
    until = law.slip_energy(torque, speed, end, off)
    after = law.run_down_energy(inertia, end, torque, 0.0)
    return HeatedSlip(torque, off + law.run_down_time(inertia, end, torque, 0.0), until + after, carried)
