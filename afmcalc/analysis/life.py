"""Life of the shaft that the clutch's load swings (S19 (14)–(20)), by the paper's rule or by amplitude."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Literal

from ..drive.result import SimulateResult
from ..engines.protocol import Clutch
from ..equations import life as law
from ..equations.arrays import Values
from ..errors import AfmcalcError
from ..findings import Finding, finding
from ..messages import say, term
from ..result import Answer, Result, Series, described, quantity
from ..spec.models import Fatigue, Method
from .adjust import METHODS, set_by
from .answers import Answers
from .registry import StressRule
from .slips import RULES, Load, cycles, damaging_stress, dynamic_factor, is_static, load_of, with_modulus
from .sweep.grid import Axis, replaced, series

Setting = Literal["as-set", Method]
UNLIMITED = "unlimited"
"""A life without number."""


class MethodCycles(Result):
    """Cycles by setting; null where fatigue sets no limit and the rule has no number for it."""

    as_set: float | None = quantity("1", "N_ц", "cycles, springs as they are", null=UNLIMITED)
    min_friction: float | None = quantity("1", "N_ц,1", "cycles, if the springs were set at f_min", null=UNLIMITED)
    mean_friction: float | None = quantity(
        "1", "N_ц,2", "cycles, if the springs were set at the mean friction with margin", null=UNLIMITED
    )
    unlimited: list[Setting] = described("settings whose life fatigue does not limit")

    def words(self, name: str) -> str | None:
        """Say that a life is not limited, whatever number the S-N line gives when it is extrapolated."""
        if name == "unlimited":
            return ""  # the lives say so
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


class LifeResult(Answer):
    """Cycles to failure of the protected and the unprotected side."""

    model: StressRule = described("rule for the damaging stress")
    protected: MethodCycles = described("protected side")
    unprotected: MethodCycles = quantity("", "'", "unprotected side")
    protected_forecast: MethodCycles = quantity("", "cp", "protected side, load from T at the mean friction (S19)")
    unprotected_forecast: MethodCycles = quantity("", "'cp", "unprotected side, load from T at the mean friction (S19)")
    stress_protected: float | None = quantity("Pa", "τ_eq", "damaging stress of the protected side, as set")
    stress_unprotected: float | None = quantity("Pa", "τ'_eq", "damaging stress of the unprotected side, as set")
    endurance_limit: float = quantity("Pa", "τ_limb", "endurance limit")
    base_cycles: float = quantity("1", "N_0", "base cycles of the S-N line")
    dynamic_factor: float = quantity("1", "k_д", "dynamic factor by which the unprotected side is loaded more")
    sweep: list[LifeSweep] | None = described("life over the swept values", optional=True)


def life(
    clutch: Clutch, model: StressRule = "mean-stress", sweeps: Sequence[Axis] = (), answers: Answers | None = None
) -> tuple[LifeResult, list[Finding]]:
    """Calculate the cycles to failure: of the band as one cycle (the paper), or of slips from 0 to T(f) and back.

    In a sweep an axis named dT varies the scatter band at fixed T_min.

    Raises:
        SpecError: no [fatigue] block, or one that lacks what the model needs.
    """
    part = _part(clutch, model)
    asked_alone, answers = answers is None, answers or Answers(clutch)
    factor = dynamic_factor(clutch, lambda: answers.of(SimulateResult))
    sides = {"protected": None, "unprotected": factor}
    clutches: dict[Setting, Clutch] = {"as-set": clutch}
    made = clutch.spec.control_spring is not None and clutch.spec.control_spring.force is not None
    for method in METHODS:
        as_set = method == clutch.spec.adjustment.method and not made
        clutches[method] = clutch if as_set else set_by(clutch.spec, method, float(clutch.nominal_torque))

    def of(side: str, *, from_mean: bool = False) -> MethodCycles:
        loads = {setting: load_of(one, from_mean=from_mean).times(sides[side]) for setting, one in clutches.items()}
        numbers = {setting: _null(cycles(part, model, load)) for setting, load in loads.items()}
        return MethodCycles(
            **{setting.replace("-", "_"): number for setting, number in numbers.items()},
            unlimited=[
                setting
                for setting, number in numbers.items()
                if number is None or _is_unlimited(part, _stress(part, model, loads[setting]))
            ],
        )

    load = load_of(clutch)
    result = LifeResult(
        model=model,
        protected=of("protected"),
        unprotected=of("unprotected"),
        protected_forecast=of("protected", from_mean=True),
        unprotected_forecast=of("unprotected", from_mean=True),
        stress_protected=_stress(part, model, load),
        stress_unprotected=_stress(part, model, load.times(factor)),
        endurance_limit=part.endurance_limit,
        base_cycles=part.base_cycles,
        dynamic_factor=factor,
        sweep=life_sweep(clutch, model, sweeps, factor) or None,
    )
    about = finding("mean-stress-rule", "info")
    if RULES[model].each_slip:
        about = finding("slips-averaged", "info")
    underrated: list[Finding] = []
    if asked_alone and clutch.spec.drive.dynamic_factor is not None and clutch.spec.drive.event is not None:
        # the dynamic factor given may be smaller than that of the event
        underrated = [remark for remark in answers.ask("simulate")[1] if remark.code == "dynamic-factor-exceeded"]
    return result, [
        *clutch.findings(),
        *(remark for side, times in sides.items() for remark in _judged(part, model, side, load.times(times))),
        *underrated,
        about,
        *replaced(clutch.spec, sweeps),
    ]


def _part(clutch: Clutch, model: StressRule) -> Fatigue:
    """Return the [fatigue] block; refuse a spec without what the model needs."""
    if clutch.spec.fatigue is None:
        message = say("required by life: endurance_limit, polar_section_modulus, …")
        raise clutch.spec.refused("fatigue", message)
    part = with_modulus(clutch.spec)
    needed = RULES[model].needs
    if needed and getattr(part, needed) is None:
        raise clutch.spec.refused(f"fatigue.{needed}", say("required by the model {model!r}", model=model))
    return part


def _stress(part: Fatigue, model: StressRule, load: Load) -> float | None:
    """Damaging stress; None where the part breaks at once."""
    return None if is_static(part, load) else float(damaging_stress(part, model, load))


def _null(value: Values) -> float | None:
    """JSON has no NaN: where fatigue sets no limit there is no number."""
    return None if value != value else float(value)


def life_sweep(clutch: Clutch, model: StressRule, axes: Sequence[Axis], factor: float) -> list[LifeSweep]:
    """Calculate the life over spec keys, or over the band dT above the T_min of the spec.

    ``factor`` is that of the clutch as it is: where neither dT nor the part alone is swept, the event of every point
    gives its own.
    """
    import numpy as np

    if any(axis.name == "dT" for axis in axes):
        if len(axes) > 1:
            raise AfmcalcError("dT is swept alone: it takes the place of what the clutch gives")
        axis, part = axes[0], _part(clutch, model)
        loads = _over_band(clutch, model, axis.values, factor)
        lives: dict[str, Any] = {name: cycles(part, model, load) for name, load in loads.items()}
        lives = {name: [_null(life) for life in np.broadcast_to(of, axis.values.shape)] for name, of in lives.items()}
        return [LifeSweep(parameter=axis.name, path=axis.key.path, unit="N*m", values=axis.values.tolist(), **lives)]
    of_part = all(axis.key.path.startswith(("fatigue.", "shaft.")) for axis in axes)
    same_event = clutch.spec.drive.event is None or of_part

    def of(point: Clutch, times: Values | None = None, *, from_mean: bool = False) -> Values:
        return cycles(_part(point, model), model, load_of(point, from_mean=from_mean).times(times))

    def factor_of(point: Clutch) -> Values:
        from .simulate import dynamic_factors

        given = point.spec.drive.dynamic_factor
        return given if given is not None else factor if same_event else dynamic_factors(point)

    outputs = {
        "protected": of,
        "unprotected": lambda point: of(point, factor_of(point)),
        "protected_forecast": lambda point: of(point, from_mean=True),
    }
    return series(LifeSweep, clutch, axes, outputs, open_at=tuple(outputs)) or []


def _over_band(clutch: Clutch, model: StressRule, band: Values, factor: float) -> dict[str, Load]:
    """Loads of a clutch with another scatter band above its own T_min.

    Slips keep the course of the torque over friction, stretched; the paper's forecast keeps T_cp, and has nothing to
    say of a band so narrow that T_max stays below it.
    """
    load, forecast = load_of(clutch), load_of(clutch, from_mean=True)
    least, own_band = load.least, load.most - load.least
    over = load.stretched(least, own_band, band)
    if RULES[model].each_slip:
        upper = forecast.stretched(least, own_band, band)
    else:
        import numpy as np

        most = least + band
        mean = np.where(most >= forecast.least, forecast.least, np.nan)
        upper = Load(lambda share: mean + share * (most - mean), mean, most)
    return {"protected": over, "unprotected": over.times(factor), "protected_forecast": upper}


def parse_axes(texts: Iterable[str], clutch: Clutch, *, band: bool = False) -> list[Axis]:
    """Read the axes of a sweep; ``band`` takes dT for the scatter band, of which a life can be told."""
    from .sweep.axes import parse_axis

    return [
        band_axis(text, clutch) if band and text.partition("=")[0].strip() == "dT" else parse_axis(text, clutch.spec)
        for text in texts
    ]


def band_axis(text: str, clutch: Clutch) -> Axis:
    """Read ``dT[=RANGE]``: the scatter band, from half to twice what the clutch has, or as given."""
    import numpy as np

    from ..spec.fields import Key
    from .sweep.axes import parse_values

    key = Key("scatter", "N*m", "ΔT", "torque scatter band")
    load = load_of(clutch)
    band = float(load.most - load.least)
    _, separator, given = text.partition("=")
    values = parse_values(text, given, "N*m") if separator else np.linspace(0.5 * band, 2 * band, 26)
    if bool((values < 0).any()):
        raise AfmcalcError("--sweep {text:.80}: a scatter band is not negative", text=text)
    return Axis("dT", key, values)


def _judged(part: Fatigue, model: StressRule, side: str, load: Load) -> Iterator[Finding]:
    """Say how long a side lasts, springs as they are: no slip, so many, or without a limit by fatigue."""
    limit, path, stress = part.endurance_limit, "fatigue.endurance_limit", _stress(part, model, load)
    if stress is None:
        top = float(law.shear_stress(load.most, part.polar_section_modulus))
        strength, path = part.ultimate_strength, "fatigue.ultimate_strength"
        yield finding("static-strength-exceeded", "error", value=top, limit=strength, path=path, side=term(side))
    elif _is_unlimited(part, stress):
        code = "life-not-limited/no-number" if RULES[model].each_slip else "life-not-limited/extrapolated"
        yield finding(code, "info", value=stress, limit=limit, path=path, side=term(side))
    elif (slips := _null(cycles(part, model, load))) is not None:
        yield finding(
            "life-limited", "info", value=slips, limit=part.base_cycles, path=path, side=term(side), stress=stress,
            endurance=limit,
        )  # fmt: skip


def _is_unlimited(part: Fatigue, stress: float | None) -> bool:
    """Whether a damaging stress stays below the endurance limit."""
    return stress is not None and stress <= part.endurance_limit
