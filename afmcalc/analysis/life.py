"""Life of the shaft that the clutch's load swings (S19 (14)–(20)), by the paper's rule or by amplitude."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

from ..arrays import is_array, larger, smaller
from ..engines.protocol import Clutch
from ..equations import life as law
from ..errors import AfmcalcError, Problem, SpecError
from ..findings import Finding
from ..messages import say
from ..result import Result, Series, quantity
from ..spec.models import Fatigue, Method
from .adjust import METHODS, set_by
from .sweep.grid import Axis, grid

if TYPE_CHECKING:
    from ..spec import Spec

Model = Literal["mean-stress", "amplitude", "goodman"]


class MethodCycles(Result):
    """Cycles by adjustment method; null where the life is not limited by fatigue."""

    min_friction: float | None = quantity("1", "N_1", "cycles, set at f_min", null="no limit")
    mean_friction: float | None = quantity("1", "N_2", "cycles, set at the mean friction with margin", null="no limit")


class LifeSweep(Series):
    """Life over a swept key, or over the scatter band (dT)."""

    protected: list[float | None] = quantity("1", "N", "cycles of the protected side, as set", null="no limit")
    unprotected: list[float | None] = quantity("1", "N'", "cycles of the unprotected side, as set", null="no limit")
    protected_forecast: list[float | None] = quantity(
        "1", "N_cp", "cycles of the protected side, load from T_cp, as set", null="no limit"
    )


class LifeResult(Result):
    """Cycles to failure of the protected and the unprotected side."""

    model: Model = quantity("", None, "rule for the damaging stress")
    protected: MethodCycles = quantity("", None, "protected side")
    unprotected: MethodCycles = quantity("", None, "unprotected side")
    protected_forecast: MethodCycles = quantity("", None, "protected side, load from T at the mean friction (S19)")
    unprotected_forecast: MethodCycles = quantity("", None, "unprotected side, load from T at the mean friction (S19)")
    stress_protected: float | None = quantity("Pa", "τ_eq", "damaging stress of the protected side, as set")
    stress_unprotected: float | None = quantity("Pa", "τ'_eq", "damaging stress of the unprotected side, as set")
    endurance_limit: float = quantity("Pa", "τ_limb", "endurance limit")
    base_cycles: float = quantity("1", "N_0", "base cycles of the S-N line")
    sweep: list[LifeSweep] | None = quantity("", None, "life over the swept values", optional=True, columns=True)


def life(clutch: Clutch, model: Model = "mean-stress", sweeps: Sequence[Axis] = ()) -> tuple[LifeResult, list[Finding]]:
    """Calculate the cycles to failure.

    Args:
        clutch: the clutch; its spec needs a [fatigue] block.
        model: ``mean-stress`` (the paper's), ``amplitude`` (Серенсен–Кинасошвили) or ``goodman``.
        sweeps: axes of a sweep; an axis named dT varies the scatter band at fixed T_min.

    Raises:
        SpecError: no [fatigue] block, or one that lacks what the model needs.
    """
    part = _part(clutch, model)
    factor = clutch.spec.drive.dynamic_factor
    nominal = float(clutch.nominal_torque)
    loads = {method: _loads(set_by(clutch.spec, method, nominal)) for method in METHODS}

    def cycles(dynamic: float, forecast: bool) -> MethodCycles:
        lows = {method: (load[1] if forecast else load[0], load[2]) for method, load in loads.items()}
        values = {m.replace("-", "_"): _single(part, model, dynamic * a, dynamic * b) for m, (a, b) in lows.items()}
        return MethodCycles(**values)

    low, _, high = _loads(clutch)
    result = LifeResult(
        model=model,
        protected=cycles(1.0, False),
        unprotected=cycles(factor, False),
        protected_forecast=cycles(1.0, True),
        unprotected_forecast=cycles(factor, True),
        stress_protected=_damaging(part, model, low, high),
        stress_unprotected=_damaging(part, model, factor * low, factor * high),
        endurance_limit=part.endurance_limit,
        base_cycles=part.base_cycles,
        sweep=_sweep(clutch, part, model, sweeps) if sweeps else None,
    )
    found = [
        *_unlimited(part, model, {m: (a, b) for m, (a, _, b) in loads.items()}, factor),
        *_static(part, high, factor),
    ]
    return result, [*clutch.findings(), *found, *_rule_findings(model)]


def _part(clutch: Clutch, model: Model) -> Fatigue:
    """Return the [fatigue] block; refuse a spec without what the model needs."""
    part = clutch.spec.fatigue
    if part is None:
        raise SpecError(
            clutch.spec.label,
            [Problem("fatigue", None, say("required by life: endurance_limit, polar_section_modulus, …"))],
        )
    needed = {"amplitude": "mean_stress_sensitivity", "goodman": "ultimate_strength"}.get(model)
    if needed and getattr(part, needed) is None:
        raise SpecError(
            clutch.spec.label, [Problem(f"fatigue.{needed}", None, say("required by the model {model!r}", model=model))]
        )
    return part


def _loads(clutch: Clutch) -> tuple[float, float, float]:
    """T_min, T_cp, T_max along the common path."""
    first, second = clutch.friction
    ends = sorted((float(clutch.torque(first.min, second.min)), float(clutch.torque(first.max, second.max))))
    return ends[0], float(clutch.torque(first.mean, second.mean)), ends[1]


def _stress(part: Fatigue, model: Model, low: Any, high: Any) -> Any:
    """Damaging stress of a load that swings from ``low`` to ``high``."""
    stresses = [law.shear_stress(torque, part.polar_section_modulus) for torque in (low, high)]
    if model == "amplitude":
        return law.equivalent_stress_sensitivity(stresses[0], stresses[1], part.mean_stress_sensitivity)
    if model == "goodman":
        return law.equivalent_stress_goodman(stresses[0], stresses[1], part.ultimate_strength)
    return law.mean_stress(stresses[0], stresses[1])


def _is_static(part: Fatigue, model: Model, high: Any) -> Any:
    """Whether the largest load reaches the ultimate strength: the shaft fails at once, by Goodman's line too."""
    if model != "goodman":
        return high != high
    assert part.ultimate_strength is not None
    return law.shear_stress(high, part.polar_section_modulus) >= part.ultimate_strength


def _damaging(part: Fatigue, model: Model, low: float, high: float) -> float | None:
    """Damaging stress; None where the shaft fails at once."""
    return None if _is_static(part, model, high) else float(_stress(part, model, low, high))


def cycles_at(part: Fatigue, model: Model, low: Any, high: Any) -> Any:
    """Cycles of a load that swings from ``low`` to ``high``: NaN where fatigue sets no limit, 0 at static failure."""
    line = part.exponent, part.base_cycles
    if not (is_array(low) or is_array(high)):
        if _is_static(part, model, high):
            return 0.0
        stress = _stress(part, model, low, high)
        found = law.cycles(part.endurance_limit, stress, *line) if stress > 0 else math.nan
        return found if model == "mean-stress" or stress > part.endurance_limit else math.nan
    import numpy as np

    with np.errstate(all="ignore"):
        stress = np.asarray(_stress(part, model, low, high), float)
        found = np.asarray(law.cycles(part.endurance_limit, stress, *line), float)
    if model == "mean-stress":
        return found
    return np.where(_is_static(part, model, high), 0.0, np.where(stress > part.endurance_limit, found, np.nan))


def _single(part: Fatigue, model: Model, low: float, high: float) -> float | None:
    return _null(float(cycles_at(part, model, low, high)))


def _null(value: float) -> float | None:
    return None if value != value else value


def _sweep(clutch: Clutch, part: Fatigue, model: Model, axes: Sequence[Axis]) -> list[LifeSweep]:
    """Life over spec keys, or over the band dT at the T_min and T_cp of the spec."""
    import numpy as np

    from .sweep.points import evaluate

    factor = clutch.spec.drive.dynamic_factor
    points = grid(axes)
    loads: dict[str, Any]
    if any(axis.name == "dT" for axis in axes):
        if len(axes) > 1:
            raise AfmcalcError(say("dT is swept alone: it takes the place of what the clutch gives"))
        least, mean, _ = _loads(clutch)
        loads = {"low": least, "mean": mean, "high": least + points[0]}
    else:
        values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
        outputs = {
            "low": lambda c: c.torque(c.friction[0].min, c.friction[1].min),
            "mean": lambda c: c.torque(c.friction[0].mean, c.friction[1].mean),
            "high": lambda c: c.torque(c.friction[0].max, c.friction[1].max),
        }
        loads = evaluate(clutch.spec, values, outputs)
    low, high = smaller(loads["low"], loads["high"]), larger(loads["low"], loads["high"])
    answers = {
        "protected": cycles_at(part, model, low, high),
        "unprotected": cycles_at(part, model, factor * low, factor * high),
        # a band so narrow that T_max stays below T_cp leaves nothing to forecast
        "protected_forecast": np.where(
            high >= loads["mean"], cycles_at(part, model, smaller(loads["mean"], high), high), np.nan
        ),
    }
    lists = {name: [_null(value) for value in array.tolist()] for name, array in answers.items()}
    return [
        LifeSweep(parameter=axis.name, path=axis.key.path, unit=axis.key.unit or "1", values=given.tolist(), **lists)
        for axis, given in zip(axes, points, strict=True)
    ]


def band_axis(text: str, spec: "Spec") -> Axis:
    """Read ``dT[=RANGE]``: the scatter band, from half to twice what the clutch has, or as given."""
    from ..engines import build
    from ..spec.paths import Key
    from .sweep.ranges import parse_values

    key = Key("scatter", "N*m", "ΔT", "torque scatter band")
    clutch = build(spec)
    low, _, high = _loads(clutch)
    _, separator, given = text.partition("=")
    import numpy as np

    values = parse_values(text, given, "N*m") if separator else np.linspace(0.5 * (high - low), 2 * (high - low), 26)
    if bool((values < 0).any()):
        raise AfmcalcError(say("--sweep {text}: a scatter band is not negative", text=text))
    return Axis("dT", key, values)


def _unlimited(
    part: Fatigue, model: Model, loads: Mapping[Method, tuple[float, float]], factor: float
) -> list[Finding]:
    """Say where the damaging stress stays below the endurance limit, by side and setting."""
    number = (
        "the number extrapolates the S-N line, as the paper does" if model == "mean-stress" else "no number is given"
    )
    found = []
    for side, dynamic in (("protected", 1.0), ("unprotected", factor)):
        stresses = {m: _damaging(part, model, dynamic * low, dynamic * high) for m, (low, high) in loads.items()}
        below = {m: stress for m, stress in stresses.items() if stress is not None and stress <= part.endurance_limit}
        if not below:
            continue
        listed = ", ".join(f"{stress / 1e6:.4g} MPa ({method})" for method, stress in below.items())
        message = (
            f"{side} side: the damaging stress, {listed}, is below the endurance limit "
            f"{part.endurance_limit / 1e6:.4g} MPa: life is not limited by fatigue ({number})"
        )
        found.append(
            Finding(
                level="info", code="life-not-limited", message=message, value=min(below.values()),
                limit=part.endurance_limit, path="fatigue.endurance_limit",
            )
        )  # fmt: skip
    return found


def _static(part: Fatigue, largest: float, factor: float) -> list[Finding]:
    """Say which side's largest stress, as set, reaches the ultimate strength."""
    found = []
    for side, dynamic in (("protected", 1.0), ("unprotected", factor)):
        top = float(law.shear_stress(dynamic * largest, part.polar_section_modulus))
        if part.ultimate_strength is not None and top >= part.ultimate_strength:
            message = (
                f"the largest stress of the {side} side, {top / 1e6:.4g} MPa, reaches "
                f"the ultimate strength {part.ultimate_strength / 1e6:.4g} MPa: the shaft fails at once"
            )
            found.append(
                Finding(
                    level="error", code="static-strength-exceeded", message=message,
                    value=top, limit=part.ultimate_strength, path="fatigue.ultimate_strength",
                )
            )  # fmt: skip
    return found


def _rule_findings(model: Model) -> list[Finding]:
    if model != "mean-stress":
        return []
    message = (
        "the paper's rule takes the mean stress as damaging and ignores the amplitude, so a wider band at equal "
        "mean costs nothing (M23); --model amplitude or goodman weighs it"
    )
    return [Finding(level="info", code="mean-stress-rule", message=message)]
