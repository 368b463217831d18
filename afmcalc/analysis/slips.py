"""Stress and life of a part under the load of a clutch, by one cycle over the whole torque band or slip by slip.

The papers' rule takes T_min … T_max as one cycle, although a single slip loads the part from 0 to T(f) and back. The
rules by amplitude take this cycle for each slip. They assume that friction is uniformly distributed over its range, and
give the life at the mean damage (Miner; handbook, chapter 4).
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from ..drive.result import SimulateResult
from ..engines.protocol import Clutch
from ..equations import life as law
from ..equations.arrays import Values, finite, is_array
from ..equations.calls import derived, unnoted
from ..errors import given
from ..spec.models import Fatigue, Spec
from .registry import StressRule

if TYPE_CHECKING:
    from ..spec.requirements import Requirements

_FRICTIONS = 256
"""Frictions over which the damage is averaged: the middles of so many equal parts of the range."""


class Rule(NamedTuple):
    """How a swing between two stresses does damage."""

    stress: Callable[[Fatigue, Values, Values], Values]
    """Damaging stress of a swing from the smaller to the larger stress, Pa."""
    needs: str | None = None
    """Key of [fatigue] that the rule needs."""
    each_slip: bool = True
    """Whether each slip is a cycle; else the whole band is one, and the S–N line is extrapolated below its end."""


RULES: dict[StressRule, Rule] = {
    "mean-stress": Rule(lambda part, low, high: law.mean_stress(low, high), each_slip=False),
    "amplitude": Rule(
        lambda part, low, high: law.equivalent_stress_sensitivity(low, high, part.mean_stress_sensitivity or 0.0),
        "mean_stress_sensitivity",
    ),
    "goodman": Rule(
        lambda part, low, high: law.equivalent_stress_goodman(low, high, part.ultimate_strength or math.nan),
        "ultimate_strength",
    ),
}


def with_modulus(spec: "Spec | Requirements") -> Fatigue:
    """Return the [fatigue] block, with the section modulus of the shaft where its diameter gives it."""
    part, shaft = given(spec.fatigue), spec.shaft
    return part if shaft is None else part.model_copy(update={"polar_section_modulus": shaft.section_modulus})


class Load(NamedTuple):
    """Torque of a clutch along its friction range."""

    torque: Callable[[Values], Values]
    """Share (0…1) of the friction range → slip torque, N·m."""
    least: Values
    """Smallest torque, N·m."""
    most: Values
    """Largest torque, N·m."""

    def times(self, factor: Values | None) -> "Load":
        """Return the load on the unprotected side; without a factor the load itself."""
        if factor is None:
            return self
        least, most = (law.torque_unprotected(factor, end) for end in (self.least, self.most))
        return Load(lambda share: law.torque_unprotected(factor, self.torque(share)), least, most)

    def stretched(self, least: Values, from_band: Values, band: Values) -> "Load":
        """Return the curve scaled to another scatter band above ``least``; a straight line where the band was 0."""
        if not from_band:
            return Load(lambda share: least + share * band, least, least + band)

        def moved(torque: Values) -> Values:
            return least + (torque - least) * (band / from_band)

        return Load(lambda share: moved(self.torque(share)), moved(self.least), moved(self.most))


def load_of(clutch: Clutch, *, from_mean: bool = False) -> Load:
    """Return the load of a clutch from f_min, or from the mean, to f_max; f_1 and f_2 move together."""
    (least, *_), (most, *_) = clutch.extreme_torques("mean" if from_mean else "min")
    start = clutch.path_bend if from_mean else 0.0

    def torque(share: Values) -> Values:
        at = clutch.path(start + share * (1 - start))
        if not is_array(share) and share in (0, 1):  # the exact ends, without rounding
            one, two = (part.max if share else part.mean if from_mean else part.min for part in clutch.friction)
            at = one, two
        return clutch.torque(*at)

    return Load(torque, least, most)


def dynamic_factor(clutch: Clutch, event: Callable[[], SimulateResult] | None = None) -> float:
    """Dynamic factor of the unprotected side: as given, else the largest T_peak/T of the event, else 1.

    ``event`` returns the result of the event where it is simulated already; None: it is simulated here.
    """
    drive = clutch.spec.drive
    if drive.dynamic_factor is not None or drive.event is None:
        return 1.0 if drive.dynamic_factor is None else drive.dynamic_factor
    from .simulate import simulate

    return (event() if event else simulate(clutch)[0]).largest_dynamic_factor


def damaging_stress(part: Fatigue, rule: StressRule, load: Load) -> Values:
    """Largest damaging stress, Pa: of the cycle over the band, or of the slip with the largest torque."""
    chosen = RULES[rule]
    return _stress(part, chosen, 0.0 if chosen.each_slip else load.least, load.most)


def cycles(part: Fatigue, rule: StressRule, load: Load) -> Values:
    """Cycles, or slips, to failure: NaN where fatigue sets no limit, 0 where the largest load breaks the part.

    Raises:
        OverflowError: the cycles are too few, or the stress too large, for a float; 0 cycles mean a break only.
    """
    chosen, broken = RULES[rule], is_static(part, load)
    if not is_array(broken) and broken:
        return 0.0
    if chosen.each_slip:
        number = _slips(part, lambda share: _stress(part, chosen, 0.0, load.torque(share)))
    else:
        number = _line(part, damaging_stress(part, rule, load))
    if not (number.all() if is_array(number) else number):
        raise OverflowError
    if is_array(broken):
        import numpy as np

        return np.where(broken, 0.0, number)
    return number


def life_of(part: Fatigue, load: Load) -> Values:
    """Cycles of the band (S19) of an array of loads, infinite where fatigue sets no limit; NaN of no load."""
    import numpy as np

    stress = damaging_stress(part, "mean-stress", load)
    life = np.where(stress > part.endurance_limit, _line(part, stress), np.where(np.isnan(stress), np.nan, np.inf))
    return np.where(is_static(part, load), 0.0, life)


def is_static(part: Fatigue, load: Load) -> bool | Values:
    """Whether the largest load reaches the ultimate strength."""
    if part.ultimate_strength is None:
        return False
    reached = finite(law.shear_stress(load.most, part.polar_section_modulus)) >= part.ultimate_strength
    return reached if is_array(reached) else bool(reached)


def _stress(part: Fatigue, rule: Rule, low: Values, high: Values) -> Values:
    """Damaging stress of a swing from the smaller to the larger torque."""
    ends = (law.shear_stress(end, part.polar_section_modulus) for end in (low, high))
    return finite(rule.stress(part, *ends))


def _line(part: Fatigue, stress: Values) -> Values:
    """Cycles on the S–N line, extrapolated below its end as the paper does; NaN without stress."""
    line = part.exponent, part.base_cycles
    if not any(map(is_array, (stress, part.endurance_limit, *line))):
        return float(law.cycles(part.endurance_limit, stress, *line)) if stress > 0 else math.nan
    import numpy as np

    with np.errstate(all="ignore"):
        return np.where(np.asarray(stress) > 0, law.cycles(part.endurance_limit, stress, *line), np.nan)


def _slips(part: Fatigue, stress: Callable[[Values], Values]) -> Values:
    """Slips to failure, 1/E[1/N] over the friction range; NaN where no slip comes above the endurance limit."""
    import numpy as np

    limit, line = part.endurance_limit, (part.exponent, part.base_cycles)
    ends = stress(0.0), stress(1.0)
    shares = (np.arange(_FRICTIONS) + 0.5) / _FRICTIONS
    with unnoted(), np.errstate(all="ignore"):
        of_slips = np.asarray(stress(shares.reshape(-1, *(1,) * np.broadcast(*ends, limit, *line).ndim)))
        damage = np.where(of_slips > limit, 1 / law.cycles(limit, of_slips, *line), 0.0).mean(axis=0)
    if damage.ndim:
        with np.errstate(all="ignore"):
            return np.where(damage > 0, 1 / damage, np.nan)
    # `explain` names the stresses at both ends of the range as the origin of the mean damage
    return float(law.cycles_of_mean_damage(derived(float(damage), *ends))) if damage > 0 else math.nan
