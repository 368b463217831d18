"""What one trip turns into heat: from the simulation of the drive, or from its motor side running down (V1)."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Literal, NamedTuple

from ...arrays import Values
from ...engines.protocol import Clutch
from ...equations import heat as law
from ...errors import Problem, SpecError
from ...findings import Finding
from ...messages import say
from ...progress import counted
from ...recorders import marked, unrecorded
from ...spec.drive import Drive
from ...spec.heat import missing_of
from ..registry import ANALYSES

if TYPE_CHECKING:
    from ..answers import Answers
    from .course import Course

EnergySource = Literal["simulate", "run-down", "constant-speed"]
ENDS = ("min", "mean", "max")


class HeatedSlip(NamedTuple):
    """A slip at one friction; a time and an energy of None: it does not end."""

    torque: Values
    time: Values | None
    energy: Values | None
    course: "Course"
    """Its power over time; as far as known of one that does not end."""
    carried: bool = False
    """Whether the motor can carry the slip torque, so that only a cut-off ends it."""
    lining_share: float = 0.0
    """Share of the heat that is in the lining where the discs are hottest."""


class HeatedSlips(NamedTuple):
    """The trip at f_min, mean and f_max, and where its heat is from."""

    source: EnergySource
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
        needed = say("required by heat (or give drive.event)")
        if drive.motor is not None:
            needed = say("required by heat beside drive.motor: the slip of a motor with a curve is simulated")
        problems = [Problem(f"drive.{key}", None, needed) for key in missing]
        raise SpecError(clutch.spec.label, problems)
    assert drive.speed is not None
    source: EnergySource = "constant-speed" if drive.motor_inertia is None else "run-down"
    motor = motor_torque(clutch)
    return HeatedSlips(source, {end: _of(clutch, end, _run_down(drive, _torque(clutch, end), motor)) for end in ENDS})


def motor_torque(clutch: Clutch) -> Values:
    """M_1, N·m: as given, else the load before the trip, else the machine's nominal torque."""
    drive = clutch.spec.drive
    given = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    return clutch.machine_torque if given is None else given


def _simulated(clutch: Clutch, answers: "Answers | None") -> HeatedSlips:
    from ..simulate.simulate import simulate

    found, said = simulate(clutch) if answers is None else answers.ask("simulate")
    told = found.sliding_torque, found.slip_time, found.slip_energy
    at = {}
    for end in counted(say("simulating the event"), ENDS):
        torque, time, energy = (getattr(each, end) for each in told)
        at[end] = _of(clutch, end, HeatedSlip(torque, time, energy, _course(clutch, end)))
    ends = tuple(each for each in said if each.path in ("drive.cut_off", "drive.event.duration"))
    return HeatedSlips("simulate", at, ends)


@unrecorded()
def _course(clutch: Clutch, end: str) -> "Course":
    from ..simulate.cases import case_of
    from .course import course_of

    course = case_of(clutch, *(getattr(own, end) for own in clutch.friction)).run().course
    return course_of((each.time, float(law.slip_power(each.torque, each.slip)), each.heat) for each in course)


def _of(clutch: Clutch, end: str, slip: HeatedSlip) -> HeatedSlip:
    """The slip, and for an explanation the friction that its heat is for."""
    return slip if slip.energy is None else slip._replace(energy=marked(slip.energy, getattr(clutch.friction[1], end)))


def _torque(clutch: Clutch, end: str) -> Values:
    torque: Values = clutch.torque(*(getattr(own, end) for own in clutch.friction))
    return torque


def _run_down(drive: Drive, torque: Values, motor: Values) -> HeatedSlip:
    """V1 until the motor side stands or is switched off; switched off it runs down against the clutch alone."""
    speed, inertia, off = drive.speed, drive.motor_inertia, drive.cut_off
    assert speed is not None
    if inertia is None:
        assert off is not None
        slipped = _slipped(torque, [(0.0, speed), (off, speed)])
        return slipped._replace(energy=law.slip_energy(torque, speed, speed, off))
    carried = bool(torque <= motor)
    if not carried:
        with unrecorded():
            stands = law.run_down_time(inertia, speed, torque, motor)
        if off is None or stands <= off:
            time = law.run_down_time(inertia, speed, torque, motor)
            energy = law.run_down_energy(inertia, speed, torque, motor)
            return _slipped(torque, [(0.0, speed), (time, 0.0)])._replace(energy=energy)
    if off is None:
        return _slipped(torque, [(0.0, speed)])._replace(time=None, energy=None, carried=carried)
    # a motor that can carry the slip torque goes on at its speed
    end = speed if carried else law.speed_after(speed, inertia, torque, motor, off)
    after, energy = law.run_down_time(inertia, end, torque, 0.0), law.run_down_energy(inertia, end, torque, 0.0)
    found = _slipped(torque, [(0.0, speed), (off, end), (off + after, 0.0)])
    until = law.slip_energy(torque, speed, end, off)
    return found._replace(energy=until + energy, carried=carried)


def _slipped(torque: Values, at: Sequence[tuple[Values, Values]]) -> HeatedSlip:
    """A slip whose speed changes evenly between moments: time and speed."""
    from .course import course_of

    moments, energy = [(0.0, float(law.slip_power(torque, at[0][1])), 0.0)], 0.0
    with unrecorded():  # how the power falls from there, and the heat grows
        for (before, first), (time, last) in pairwise(at):
            energy = energy + law.slip_energy(torque, first, last, time - before)
            moments.append((float(time), float(law.slip_power(torque, last)), float(energy)))
    return HeatedSlip(torque, at[-1][0], energy, course_of(moments))
