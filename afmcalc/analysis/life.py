"""Life of the shaft that the clutch's load swings (S19 (14)–(20)), by the paper's rule or by amplitude."""

from collections.abc import Iterator, Mapping, Sequence

from ..arrays import Values
from ..engines.protocol import Clutch
from ..equations import life as law
from ..errors import AfmcalcError, Problem, SpecError
from ..findings import Finding, finding
from ..messages import joined, say, term
from ..result import Result, Series, quantity
from ..spec.fatigue import Fatigue
from ..spec.models import Method
from .adjust import METHODS, set_by
from .registry import StressRule
from .slips import RULES, Load, cycles, damaging_stress, is_static, load_of
from .sweep.grid import Axis, grid

UNLIMITED = "unlimited"
"""A life without number."""


class MethodCycles(Result):
    """Cycles by adjustment method; null where fatigue sets no limit and the rule has no number for it."""

    min_friction: float | None = quantity("1", "N_ц,1", "cycles, set at f_min", null=UNLIMITED)
    mean_friction: float | None = quantity("1", "N_ц,2", "cycles, set at the mean friction with margin", null=UNLIMITED)
    unlimited: list[Method] = quantity("", None, "settings whose life fatigue does not limit", told=True)

    def words(self, name: str) -> str | None:
        """Say that a life is not limited, whatever number the S-N line gives when it is extrapolated."""
        value = getattr(self, name)
        if isinstance(value, float) and name.replace("_", "-") in self.unlimited:
            return say("unlimited ({value:.5g})", value=value)
        return None


class LifeSweep(Series):
    """Life over a swept key, or over the scatter band (dT)."""

    protected: list[float | None] = quantity("1", "N_ц", "cycles of the protected side, as set", null=UNLIMITED)
    unprotected: list[float | None] = quantity("1", "N'_ц", "cycles of the unprotected side, as set", null=UNLIMITED)
    protected_forecast: list[float | None] = quantity(
        "1", "N_ц,cp", "cycles of the protected side, load from T_cp, as set", null=UNLIMITED
    )


class LifeResult(Result):
    """Cycles to failure of the protected and the unprotected side."""

    model: StressRule = quantity("", None, "rule for the damaging stress")
    protected: MethodCycles = quantity("", None, "protected side")
    unprotected: MethodCycles = quantity("", "'", "unprotected side")
    protected_forecast: MethodCycles = quantity("", "cp", "protected side, load from T at the mean friction (S19)")
    unprotected_forecast: MethodCycles = quantity("", "'cp", "unprotected side, load from T at the mean friction (S19)")
    stress_protected: float | None = quantity("Pa", "τ_eq", "damaging stress of the protected side, as set")
    stress_unprotected: float | None = quantity("Pa", "τ'_eq", "damaging stress of the unprotected side, as set")
    endurance_limit: float = quantity("Pa", "τ_limb", "endurance limit")
    base_cycles: float = quantity("1", "N_0", "base cycles of the S-N line")
    dynamic_factor: float | None = quantity(
        "1", "k_д", "dynamic factor by which the unprotected side is loaded more", optional=True
    )
    sweep: list[LifeSweep] | None = quantity("", None, "life over the swept values", optional=True, columns=True)


def life(
    clutch: Clutch, model: StressRule = "mean-stress", sweeps: Sequence[Axis] = ()
) -> tuple[LifeResult, list[Finding]]:
    """Calculate the cycles to failure: of the band as one cycle (the paper), or of slips from T_low to T(f) and back.

    Args:
        clutch: the clutch; its spec needs a [fatigue] block.
        model: ``mean-stress`` (the paper's), ``amplitude`` (Серенсен–Кинасошвили) or ``goodman``.
        sweeps: axes of a sweep; an axis named dT varies the scatter band at fixed T_min.

    Raises:
        SpecError: no [fatigue] block, or one that lacks what the model needs.
    """
    part, sides = _part(clutch, model), _sides(clutch)
    nominal = float(clutch.nominal_torque)
    by_method = {method: set_by(clutch.spec, method, nominal) for method in METHODS}

    def of(side: str, *, from_mean: bool = False) -> MethodCycles:
        loads = {method: load_of(own, from_mean=from_mean).times(sides[side]) for method, own in by_method.items()}
        first, second = (_null(cycles(part, model, load)) for load in loads.values())
        return MethodCycles(min_friction=first, mean_friction=second, unlimited=list(_below(part, model, loads)))

    load = load_of(clutch)
    result = LifeResult(
        model=model,
        protected=of("protected"),
        unprotected=of("unprotected"),
        protected_forecast=of("protected", from_mean=True),
        unprotected_forecast=of("unprotected", from_mean=True),
        stress_protected=_stress(part, model, load),
        stress_unprotected=_stress(part, model, load.times(sides["unprotected"])),
        endurance_limit=part.endurance_limit,
        base_cycles=part.base_cycles,
        dynamic_factor=clutch.spec.drive.dynamic_factor,
        sweep=life_sweep(clutch, model, sweeps) if sweeps else None,
    )
    loads = {method: load_of(own) for method, own in by_method.items()}
    about = (
        [finding("mean-stress-rule", "info")]
        if not RULES[model].each_slip
        else [finding("slips-averaged", "info", value=part.load_low, path="fatigue.load_low")]
    )
    return result, [
        *clutch.findings(),
        *_unlimited(part, model, loads, sides),
        *_limited(part, model, load, sides),
        *_static(part, load, sides),
        *about,
    ]


def _part(clutch: Clutch, model: StressRule) -> Fatigue:
    """Return the [fatigue] block; refuse a spec without what the model needs."""
    part = clutch.spec.fatigue
    if part is None:
        message = say("required by life: endurance_limit, polar_section_modulus, …")
        raise SpecError(clutch.spec.label, [Problem("fatigue", None, message)])
    needed = RULES[model].needs
    if needed and getattr(part, needed) is None:
        message = say("required by the model {model!r}", model=model)
        raise SpecError(clutch.spec.label, [Problem(f"fatigue.{needed}", None, message)])
    return part


def _sides(clutch: Clutch) -> dict[str, float | None]:
    """Side of the clutch → what its torque is multiplied by, if it is."""
    return {"protected": None, "unprotected": clutch.spec.drive.dynamic_factor}


def _stress(part: Fatigue, model: StressRule, load: Load) -> float | None:
    """Damaging stress; None where the part breaks at once."""
    return None if is_static(part, load) else float(damaging_stress(part, model, load))


def _null(value: Values) -> float | None:
    """JSON has no NaN: where fatigue sets no limit there is no number."""
    return None if value != value else float(value)


def life_sweep(clutch: Clutch, model: StressRule, axes: Sequence[Axis]) -> list[LifeSweep]:
    """Calculate the life over spec keys, or over the band dT above the T_min of the spec.

    Raises:
        SpecError: no [fatigue] block, or one that lacks what the model needs.
    """
    import numpy as np

    from .sweep.points import evaluate

    part, points = _part(clutch, model), grid(axes)
    answers: Mapping[str, Values]
    if any(axis.name == "dT" for axis in axes):
        if len(axes) > 1:
            raise AfmcalcError(say("dT is swept alone: it takes the place of what the clutch gives"))
        answers = {name: cycles(part, model, load) for name, load in _over_band(clutch, model, points[0]).items()}
    else:
        values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}

        def of(own: Clutch, side: str, *, from_mean: bool = False) -> Values:
            return cycles(_part(own, model), model, load_of(own, from_mean=from_mean).times(_sides(own)[side]))

        outputs = {
            "protected": lambda own: of(own, "protected"),
            "unprotected": lambda own: of(own, "unprotected"),
            "protected_forecast": lambda own: of(own, "protected", from_mean=True),
        }
        answers = evaluate(clutch.spec, values, outputs)
    size = points[0].size
    lists = {name: [_null(value) for value in np.broadcast_to(array, size)] for name, array in answers.items()}
    return [
        LifeSweep(parameter=axis.name, path=axis.key.path, unit=axis.key.unit or "1", values=given.tolist(), **lists)
        for axis, given in zip(axes, points, strict=True)
    ]


def _over_band(clutch: Clutch, model: StressRule, band: Values) -> dict[str, Load]:
    """Loads of a clutch with another scatter band above its own T_min.

    Slips keep the course of the torque over friction, stretched; the paper's forecast keeps T_cp, and has nothing to
    say of a band so narrow that T_max stays below it.
    """
    own, forecast = load_of(clutch), load_of(clutch, from_mean=True)
    least, had = own.least, own.most - own.least
    over = own.stretched(least, had, band)
    if RULES[model].each_slip:
        upper = forecast.stretched(least, had, band)
    else:
        import numpy as np

        most = least + band
        mean = np.where(most >= forecast.least, forecast.least, np.nan)
        upper = Load(lambda share: mean + share * (most - mean), mean, most)
    return {"protected": over, "unprotected": over.times(_sides(clutch)["unprotected"]), "protected_forecast": upper}


def band_axis(text: str, clutch: Clutch) -> Axis:
    """Read ``dT[=RANGE]``: the scatter band, from half to twice what the clutch has, or as given."""
    import numpy as np

    from ..spec.walk import Key
    from .sweep.ranges import parse_values

    key = Key("scatter", "N*m", "ΔT", "torque scatter band")
    load = load_of(clutch)
    band = float(load.most - load.least)
    _, separator, given = text.partition("=")
    values = parse_values(text, given, "N*m") if separator else np.linspace(0.5 * band, 2 * band, 26)
    if bool((values < 0).any()):
        raise AfmcalcError(say("--sweep {text:.80}: a scatter band is not negative", text=text))
    return Axis("dT", key, values)


def _unlimited(
    part: Fatigue, model: StressRule, loads: Mapping[Method, Load], sides: Mapping[str, float | None]
) -> list[Finding]:
    """Say where the damaging stress stays below the endurance limit, by side and setting."""
    limit, path = part.endurance_limit, "fatigue.endurance_limit"
    each_slip, found = RULES[model].each_slip, []
    for side, factor in sides.items():
        if below := _below(part, model, {method: load.times(factor) for method, load in loads.items()}):
            listed = joined(say("{stress:.4g MPa} ({method})", stress=s, method=term(m)) for m, s in below.items())
            found.append(
                finding(
                    "life-not-limited/no-number" if each_slip else "life-not-limited/extrapolated", "info",
                    value=min(below.values()), limit=limit, path=path, side=term(side), listed=listed,
                )
            )  # fmt: skip
    return found


def _limited(part: Fatigue, model: StressRule, load: Load, sides: Mapping[str, float | None]) -> Iterator[Finding]:
    """Say how many slips a side lasts, spring as set, where fatigue limits them."""
    limit, path = part.base_cycles, "fatigue.endurance_limit"
    for side, factor in sides.items():
        stress, slips = _stress(part, model, load.times(factor)), _null(cycles(part, model, load.times(factor)))
        if stress is not None and stress > part.endurance_limit and slips is not None:
            yield finding(
                "life-limited", "info", value=slips, limit=limit, path=path, side=term(side), stress=stress,
                endurance=part.endurance_limit,
            )  # fmt: skip


def _below(part: Fatigue, model: StressRule, loads: Mapping[Method, Load]) -> dict[Method, float]:
    """Settings whose damaging stress stays below the endurance limit, and that stress."""
    stresses = {method: _stress(part, model, load) for method, load in loads.items()}
    return {method: each for method, each in stresses.items() if each is not None and each <= part.endurance_limit}


def _static(part: Fatigue, load: Load, sides: Mapping[str, float | None]) -> list[Finding]:
    """Say which side's largest stress, as set, reaches the ultimate strength."""
    limit, path = part.ultimate_strength, "fatigue.ultimate_strength"
    found = []
    for side, factor in sides.items():
        if is_static(part, load.times(factor)):
            top = float(law.shear_stress(load.times(factor).most, part.polar_section_modulus))
            found.append(
                finding("static-strength-exceeded", "error", value=top, limit=limit, path=path, side=term(side))
            )
    return found
