"""An event as it goes: torques, speeds and travel over time."""

from collections.abc import Iterable

from ...engines.protocol import Clutch
from ...messages import say
from ...progress import counted
from ...result import Answer, Result, quantity
from ..torque import Pair, friction_fields, pairs_asked
from .cases import case_of, peak_time


class MomentRow(Result):
    """One moment of an event at one friction."""

    friction: float | None = quantity("1", "f", "coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    friction_driven: float | None = quantity("1", "f_2", "friction of the driven pairs", optional=True)
    time: float = quantity("s", None, "time")
    torque_shaft: float = quantity("N*m", "T_s", "torque in the shaft")
    torque_clutch: float = quantity("N*m", "T_c", "torque of the clutch")
    speed_motor: float = quantity("rad/s", "ω_1", "speed of the motor side")
    speed_driven: float = quantity("rad/s", "ω_2", "speed of the driven half")
    speed_tool: float = quantity("rad/s", "ω_3", "speed of the tool")
    travel: float | None = quantity("m", "x", "travel of the sleeve", optional=True)


class HistoryResult(Answer):
    """The events at every friction asked for, one after the other."""

    moments: list[MomentRow] = quantity("", None, "moments")


def history(clutch: Clutch, friction: Iterable[Pair] = (), *, short: bool = False) -> HistoryResult:
    """Simulate events and keep their course.

    Args:
        clutch: a clutch with float parameters and an event.
        friction: pairs (f, None) or (f_1, f_2); none for f_min, mean friction and f_max.
        short: only until the peak has passed.

    Raises:
        SpecError: the spec has no event.
        AfmcalcError: SciPy is missing.
    """
    unlike = clutch.spec.friction.unlike
    ends = [(first, second if unlike else None) for first, second in zip(*clutch.friction, strict=True)]
    rows = []
    for pair in counted(say("simulating the event"), pairs_asked(clutch, friction) or ends):
        case = case_of(clutch, *pair)
        if short:
            window = float(peak_time(case.plant.train, case.plant.sliding))
            case = case._replace(horizon=min(case.horizon, window))
        own = friction_fields(clutch, *pair)
        for moment in case.run(recorded=True).history:
            given = moment._asdict()
            if not clutch.spec.kind.travels:
                del given["travel"]
            rows.append(MomentRow(**own, **given))
    return HistoryResult(moments=rows)
