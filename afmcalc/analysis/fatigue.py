"""Fatigue life of the shaft under the torque of the clutch (S19 (14)–(20)), by the paper's rule or by amplitude.

The papers' rule takes T_min … T_max as one cycle, although a single slip loads the part from 0 to T(f) and back. The
rules by amplitude take each slip, 0 to T(f), as one cycle; life follows from the mean damage (Miner; handbook, 4).
"""

from collections.abc import Iterable, Sequence
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
from ..spec.quantity import Quantity
from .adjust import METHODS
from .asking import Answers, Asking, answer, asked
from .clutch_findings import clutch_findings
from .drive_result import SimulateResult, dynamic_factor
from .registry import StressRule
from .sweep import Axis, parse_axis, parse_values, replaced, series

Setting = Literal["as-set", Method]
UNLIMITED = "unlimited"
"""Text shown for a life that fatigue does not limit."""
_NEEDS: dict[StressRule, str] = {"amplitude": "mean_stress_sensitivity", "goodman": "ultimate_strength"}
"""Rule that counts each slip as one cycle → key of [fatigue] that the rule needs."""


class MethodCycles(Result):
    """Cycles by setting; null where fatigue sets no limit and the rule has no number for it."""

    as_set: float | None = quantity("1", "N_ц", "cycles, springs as they are", null=UNLIMITED)
    min_friction: float | None = quantity("1", "N_ц,1", "cycles, if the springs were set at f_min", null=UNLIMITED)
    mean_friction: float | None = quantity(
        "1", "N_ц,2", "cycles, if the springs were set at the mean friction with margin", null=UNLIMITED
    )
    unlimited: list[Setting] = described("settings whose life fatigue does not limit")

    def words(self, name: str) -> str | None:
        """Text of an unlimited life, with its cycles on the extrapolated S-N line; None: the value itself is shown."""
        if name == "unlimited":
            return ""  # the setting is shown with each life
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
    """Calculate the cycles to failure; a cycle is the whole band by the paper's rule, and one slip by other rules.

    In a sweep an axis named dT varies the scatter band at fixed T_min. Raises SpecError if there is no [fatigue] block,
    or if the block lacks the key that ``model`` needs.
    """
    spec = clutch.spec
    if spec.fatigue is None:
        raise spec.refused("fatigue", say("required by life: endurance_limit, polar_section_modulus, …"))
    if (needed := _NEEDS.get(model)) and getattr(spec.fatigue, needed) is None:
        raise spec.refused(f"fatigue.{needed}", say("required by the model {model!r}", model=model))
    underrated: list[Finding] = []
    if answers is None and spec.drive.event is not None:
        answers = Answers(build(spec))
        if spec.drive.dynamic_factor is not None:  # the given factor may be less than the factor of the event
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
        for side, load in sides.items():
            if _is_unlimited(load):
                code = "life-not-limited/no-number" if model in _NEEDS else "life-not-limited/extrapolated"
                about = {"value": _stress(load), "limit": load["endurance_limit"], "path": "fatigue.endurance_limit"}
                judged.append(finding(code, "info", **about, side=translate(side)))
    rule = finding("slips-averaged" if model in _NEEDS else "mean-stress-rule", "info")
    return result, [*clutch_findings(clutch), *judged, *underrated, rule, *replaced(spec, sweeps)]


_SIDES = {
    "protected": (), "unprotected": ("unprotected",), "protected_forecast": ("forecast",),
    "unprotected_forecast": ("unprotected", "forecast"),
}  # fmt: skip
"""Side of the clutch, with its load as set or forecast from the mean friction → cases that make up the load."""


def _load(own: Quantities, side: str) -> Quantities:
    """Quantities of the clutch in the cases that make up the load of a side in ``_SIDES``."""
    return reduce(lambda load, case: load.at(case), _SIDES[side], own)


def _by_setting(spec: Spec, own: Quantities, side: str) -> MethodCycles:
    """Cycles to failure of a side, with the springs as in the spec and as each adjustment method sets them."""
    made = spec.control_spring is not None and spec.control_spring.force is not None
    numbers, unlimited = dict[str, float | None](), list[Setting]()
    settings: list[tuple[Setting, str]] = [("as-set", ""), *METHODS.items()]
    for setting, case in settings:
        load = _load(own.at("" if setting == spec.adjustment.method and not made else case), side)
        cycles = lives_of(load)
        numbers[setting.replace("-", "_")] = None if np.isnan(cycles) else float(cycles)
        if np.isnan(cycles) or _is_unlimited(load):
            unlimited.append(setting)
    return MethodCycles(**numbers, unlimited=unlimited)


def lives_of(load: Quantities) -> Values:
    """Return the cycles to failure of one clutch or of many, NaN where fatigue sets no limit.

    Raises OverflowError if the cycles round to 0 although the shaft does not break: 0 must only mean a break.
    """
    cycles = np.asarray(load["cycles_extrapolated"], float)
    if ((cycles == 0) & ~np.asarray(load["is_broken"], bool)).any():
        raise OverflowError
    return np.where(np.isfinite(cycles), cycles, np.nan)


def _stress(load: Quantities) -> float | None:
    """Damaging stress, Pa; None if the shaft breaks at once."""
    return None if load["is_broken"] else float(load["damaging_stress"])


def _is_unlimited(load: Quantities) -> bool:
    """True if the damaging stress stays below the endurance limit."""
    stress = _stress(load)
    return stress is not None and stress <= load["endurance_limit"]


def life_sweep(clutch: Clutch, model: StressRule, axes: Sequence[Axis], factor: float) -> list[LifeSweep]:
    """Calculate the life over spec keys, or over the scatter band dT above the clutch's T_min.

    ``factor``: dynamic factor of the clutch as it is, for dT and for keys of [fatigue] and [shaft]; over other keys
    each point has the dynamic factor of its own event.
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
    return series(LifeSweep, clutch.spec, axes, outputs, open_at=_SWEPT) or []


_SWEPT = ("protected", "unprotected", "protected_forecast")


def _with_band(own: Quantities, load: Quantities, band: Floats, model: StressRule) -> Quantities:
    """Return the load of a clutch with another scatter band above the clutch's T_min.

    For rules that count slips the torques of all slips are stretched alike. The paper's forecast keeps the torque T_cp
    at the mean friction, and is NaN if the band is so narrow that T_max lies below T_cp.
    """
    least, width = own["torque_min"], own["scatter"]
    if model not in _NEEDS:
        most, low = least + band, load["torque_low"]
        return load.at(torque_low=np.where(most >= low, low, np.nan), torque_high=most)
    torques, most = load["torque_at_slips"] - least, load["torque_high"] - least
    if width == 0:  # a constant torque cannot be stretched: evenly spread torques replace it
        torques, most, width = spread(0.0, 1.0, 256, ends=False), 1.0, 1.0
    damage = load.at(torque_high=least + torques * (band / width))["counted_damage"]
    return load.at(torque_high=least + most * (band / width), mean_damage=mean_along(damage))


def parse_axes(texts: Iterable[str], clutch: Clutch, *, band: bool = False) -> list[Axis]:
    """Read the axes of a sweep; if ``band``, an axis may also be dT, the scatter band."""
    return [
        band_axis(text, clutch) if band and text.partition("=")[0].strip() == "dT" else parse_axis(text, clutch.spec)
        for text in texts
    ]


def band_axis(text: str, clutch: Clutch) -> Axis:
    """Read ``dT[=RANGE]``, the axis of the scatter band: by default from half to twice the band of the clutch."""
    key = Key("scatter", "ΔT", "torque scatter band", Quantity("N*m"))
    band = clutch["scatter"]
    _, separator, values_given = text.partition("=")
    values = parse_values(text, values_given, "N*m") if separator else np.linspace(0.5 * band, 2 * band, 26)
    if bool((values < 0).any()):
        raise AfmcalcError("--sweep {text:.80}: a scatter band is not negative", text=text)
    return Axis("dT", key, values)
