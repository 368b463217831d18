"""Life of the shaft that the clutch's load swings (S19 (14)–(20)), by the paper's rule or by amplitude.

The papers' rule takes T_min … T_max as one cycle, although a single slip loads the part from 0 to T(f) and back. The
rules by amplitude take this cycle for each slip, and give the life at the mean damage (Miner; handbook, chapter 4).
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from functools import partial, reduce
from typing import Literal

import numpy as np

from ..engines import Clutch, build
from ..engines.checks import failures_of
from ..engines.quantities import Quantities
from ..engines.selection import by_rule
from ..equations.arrays import Floats, Values, mean_along, spread
from ..errors import AfmcalcError, given
from ..findings import Finding, finding
from ..messages import say, translate
from ..result import Answer, Result, Series, described, quantity
from ..spec.fields import Key
from ..spec.models import Method, Spec
from .adjust import METHODS
from .asking import Answers, Asking, answer, asked
from .clutch_findings import clutch_findings
from .drive_result import SimulateResult, dynamic_factor
from .registry import StressRule
from .sweep import Axis, parse_axis, parse_values, replaced, series

Setting = Literal["as-set", Method]
UNLIMITED = "unlimited"
"""A life without number."""
_NEEDS: dict[StressRule, str] = {"amplitude": "mean_stress_sensitivity", "goodman": "ultimate_strength"}
"""Rule by which each slip is a cycle → the key of [fatigue] that it needs. The paper's takes the band as one cycle."""
_BLOCK = 1_000
"""Points of a sweep calculated at a time: each has 256 slips."""


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


class LifeResult(Asking, Answer):
    """Cycles to failure of the protected and the unprotected side."""

    model: StressRule = described("rule for the damaging stress")
    protected: MethodCycles = described("protected side")
    unprotected: MethodCycles = quantity("", "'", "unprotected side")
    protected_forecast: MethodCycles = quantity("", "cp", "protected side, load from T at the mean friction (S19)")
    unprotected_forecast: MethodCycles = quantity("", "'cp", "unprotected side, load from T at the mean friction (S19)")
    stress_protected: float | None = quantity("Pa", "τ_eq", "damaging stress of the protected side, as set")
    stress_unprotected: float | None = quantity("Pa", "τ'_eq", "damaging stress of the unprotected side, as set")
    endurance_limit: float = asked()
    base_cycles: float = asked()
    dynamic_factor: float = asked()
    sweep: list[LifeSweep] | None = described("life over the swept values", optional=True)


def life(
    clutch: Clutch, model: StressRule = "mean-stress", sweeps: Sequence[Axis] = (), answers: Answers | None = None
) -> tuple[LifeResult, list[Finding]]:
    """Calculate the cycles to failure: of the band as one cycle (the paper), or of slips from 0 to T(f) and back.

    In a sweep an axis named dT varies the scatter band at fixed T_min. Raises SpecError: no [fatigue] block, or one
    that lacks what the model needs.
    """
    spec = clutch.spec
    _require(spec, model)
    underrated: list[Finding] = []
    if answers is None and spec.drive.event is not None:
        answers = Answers(build(spec))
        if spec.drive.dynamic_factor is not None:  # it may be smaller than that of the event
            underrated = [remark for remark in answers.ask("simulate")[1] if remark.code == "dynamic-factor-exceeded"]
    factor = dynamic_factor(spec.drive, lambda: given(answers).of(SimulateResult))
    own = by_rule(clutch, model).at(dynamic_factor=factor)
    sides = {side: _load(own, side) for side in ("protected", "unprotected")}
    with np.errstate(all="ignore"):
        result = answer(
            LifeResult, own, model=model, **{side: _by_setting(spec, own, side) for side in _SIDES},
            **{f"stress_{side}": _stress(load) for side, load in sides.items()},
            sweep=life_sweep(clutch, model, sweeps, factor) or None,
        )  # fmt: skip
        judged = failures_of(spec, own, "life")
        judged += [remark for side, load in sides.items() for remark in _judged(load, model, side)]
    about = finding("slips-averaged" if model in _NEEDS else "mean-stress-rule", "info")
    return result, [*clutch_findings(clutch), *judged, *underrated, about, *replaced(spec, sweeps)]


_SIDES = {
    "protected": (), "unprotected": ("unprotected",), "protected_forecast": ("forecast",),
    "unprotected_forecast": ("unprotected", "forecast"),
}  # fmt: skip
"""Side, as set and from the mean friction on → its cases."""


def _load(own: Quantities, side: str) -> Quantities:
    """Load of a side."""
    return reduce(lambda load, case: load.at(case), _SIDES[side], own)


def _require(spec: Spec, model: StressRule) -> None:
    """Refuse a spec without what the model needs."""
    if spec.fatigue is None:
        raise spec.refused("fatigue", say("required by life: endurance_limit, polar_section_modulus, …"))
    needed = _NEEDS.get(model)
    if needed and getattr(spec.fatigue, needed) is None:
        raise spec.refused(f"fatigue.{needed}", say("required by the model {model!r}", model=model))


def _by_setting(spec: Spec, own: Quantities, side: str) -> MethodCycles:
    """Cycles of a side, springs as they are and set by both methods."""
    made = spec.control_spring is not None and spec.control_spring.force is not None
    numbers, unlimited = dict[str, float | None](), list[Setting]()
    settings: list[tuple[Setting, str]] = [("as-set", ""), *METHODS.items()]
    for setting, case in settings:
        load = _load(own.at("" if setting == spec.adjustment.method and not made else case), side)
        numbers[setting.replace("-", "_")] = number = _cycles(load)
        if number is None or _is_unlimited(load):
            unlimited.append(setting)
    return MethodCycles(**numbers, unlimited=unlimited)


def _cycles(load: Quantities) -> float | None:
    """Cycles to failure, 0 where the largest load breaks the part; None where fatigue sets no limit."""
    number = float(lives_of(load))
    return number if math.isfinite(number) else None


def lives_of(load: Quantities) -> Values:
    """Return the cycles to failure of one clutch or of many, NaN where fatigue sets no limit.

    Raises OverflowError: they are too few for a number; 0 cycles mean a break only.
    """
    cycles = np.asarray(load["cycles_extrapolated"], float)
    if ((cycles == 0) & ~np.asarray(load["is_broken"], bool)).any():
        raise OverflowError
    return np.where(np.isfinite(cycles), cycles, np.nan)


def _stress(load: Quantities) -> float | None:
    """Damaging stress; None where the part breaks at once."""
    return None if load["is_broken"] else float(load["damaging_stress"])


def _is_unlimited(load: Quantities) -> bool:
    """True if the damaging stress stays below the endurance limit."""
    stress = _stress(load)
    return stress is not None and stress <= load["endurance_limit"]


def life_sweep(clutch: Clutch, model: StressRule, axes: Sequence[Axis], factor: float) -> list[LifeSweep]:
    """Calculate the life over spec keys, or over the band dT above the T_min of the spec.

    ``factor`` is that of the clutch as it is: where neither dT nor the part alone is swept, the event of every point
    gives its own.
    """
    if any(axis.name == "dT" for axis in axes):
        if len(axes) > 1:
            raise AfmcalcError("dT is swept alone: it takes the place of what the clutch gives")
        axis, own = axes[0], by_rule(clutch, model).at(dynamic_factor=factor)
        with np.errstate(all="ignore"):
            bands = {side: lives_of(_with_band(own, _load(own, side), axis.values, model)) for side in _SWEPT}
        lists = {
            side: [None if life != life else life for life in np.broadcast_to(lives, axis.values.shape).tolist()]
            for side, lives in bands.items()
        }
        return [LifeSweep(parameter=axis.name, path=axis.key.path, unit="N*m", values=axis.values.tolist(), **lists)]
    of_part = all(axis.key.path.startswith(("fatigue.", "shaft.")) for axis in axes)

    def factor_of(point: Clutch) -> Values:
        drive = point.spec.drive
        if drive.dynamic_factor is not None or drive.event is None or of_part:
            return factor if drive.dynamic_factor is None else drive.dynamic_factor
        from .simulate import dynamic_factors

        return dynamic_factors(point)

    def lives(side: str, point: Clutch) -> Values:
        load: Quantities = by_rule(point, model)
        if side == "unprotected":
            load = load.at(dynamic_factor=factor_of(point))
        return lives_of(_load(load, side))

    outputs = {side: partial(lives, side) for side in _SWEPT}
    block = {"block": _BLOCK} if model in _NEEDS else {}
    return series(LifeSweep, clutch.spec, axes, outputs, open_at=_SWEPT, **block) or []


_SWEPT = ("protected", "unprotected", "protected_forecast")


def _with_band(own: Quantities, load: Quantities, band: Floats, model: StressRule) -> Quantities:
    """Return the load of a clutch with another scatter band above its own T_min.

    Slips keep the course of the torque over friction, stretched; the paper's forecast keeps T_cp, and has nothing to
    say of a band so narrow that T_max stays below it.
    """
    least, width = own["torque_min"], own["scatter"]
    if model not in _NEEDS:
        most, low = least + band, load["torque_low"]
        return load.at(torque_low=np.where(most >= low, low, np.nan), torque_high=most)
    torques, most = load["torque_at_slips"] - least, load["torque_high"] - least
    if width == 0:  # a straight line
        torques, most, width = spread(0.0, 1.0, 256, ends=False), 1.0, 1.0
    damage = load.at(torque_high=least + torques * (band / width))["counted_damage"]
    return load.at(torque_high=least + most * (band / width), mean_damage=mean_along(damage))


def parse_axes(texts: Iterable[str], clutch: Clutch, *, band: bool = False) -> list[Axis]:
    """Read the axes of a sweep; ``band`` takes dT for the scatter band, of which a life can be told."""
    return [
        band_axis(text, clutch) if band and text.partition("=")[0].strip() == "dT" else parse_axis(text, clutch.spec)
        for text in texts
    ]


def band_axis(text: str, clutch: Clutch) -> Axis:
    """Read ``dT[=RANGE]``: the scatter band, from half to twice what the clutch has, or as given."""
    key = Key("scatter", "N*m", "ΔT", "torque scatter band")
    band = float(clutch["scatter"])
    _, separator, values_given = text.partition("=")
    values = parse_values(text, values_given, "N*m") if separator else np.linspace(0.5 * band, 2 * band, 26)
    if bool((values < 0).any()):
        raise AfmcalcError("--sweep {text:.80}: a scatter band is not negative", text=text)
    return Axis("dT", key, values)


def _judged(load: Quantities, model: StressRule, side: str) -> Iterator[Finding]:
    """Say of a side, springs as they are, that fatigue does not limit its life."""
    if _is_unlimited(load):
        code = "life-not-limited/no-number" if model in _NEEDS else "life-not-limited/extrapolated"
        stress, limit = _stress(load), load["endurance_limit"]
        yield finding(code, "info", value=stress, limit=limit, path="fatigue.endurance_limit", side=translate(side))
