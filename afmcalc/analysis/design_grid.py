"""Grid of a search: its candidates, a mask for each check, and the Pareto front of the candidates that pass all."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engines import Clutch, build
from ..engines.checks import Check, checks_of
from ..engines.evaluate import BLOCK, SLOPE
from ..engines.quantities import Quantities
from ..engines.rings import TOUCHES, length_of, overlaps, parts_of, sizes_of
from ..equations.arrays import next_listed
from ..errors import SpecError
from ..messages import say
from ..progress import tell
from ..spec import Spec
from ..spec.edit import candidate, value_at, with_values
from ..spec.keys import is_whole, keys
from ..spec.search import MOST, SPRINGS
from ..variants import VARIANTS, variants_of

Numbers = NDArray[np.float64]
Mask = NDArray[np.bool_]
_DIGITS = 11
"""Decimal digits to which the mantissas of objectives are rounded before clutches are compared."""


Row = tuple[Check, Any, Any]
"""A check, with values and limits of many candidates: arrays, or one number for all candidates."""


def name_of(check: Check) -> str:
    """Return the name under which a check is counted: the key of its requirement, or its code."""
    return check.requirement or check.code.partition("/")[0]


class Part(NamedTuple):
    """Part of the search grid whose candidates have the same variant, material and other names, but other numbers."""

    base: Spec
    """Spec of one candidate."""
    names: dict[str, str]
    """Path → variant, material or other name."""
    axes: dict[str, Numbers]

    @property
    def size(self) -> int:
        """Number of candidates."""
        return math.prod(len(values) for values in self.axes.values())

    def values(self, numbers: NDArray[np.intp]) -> dict[str, Numbers]:
        """Path → array of values, one for each candidate in ``numbers``; candidates are counted from 0 in the part."""
        places = np.unravel_index(numbers, tuple(len(values) for values in self.axes.values()) or (1,))
        return {path: values[place] for (path, values), place in zip(self.axes.items(), places, strict=False)}

    def changes(self, number: np.intp) -> dict[str, Any]:
        """Path → value of one candidate; whole numbers are int."""
        values = self.values(np.array([number])).items()
        return self.names | {path: (int if is_whole(path) else float)(own[0]) for path, own in values}


def parts_of_search(spec: Spec) -> list[Part]:
    """Return the parts of a search grid, one part for each combination of names, such as variant and material.

    Raises SpecError if there is no [search], if it has too many candidates, or if no candidate of a part is valid.
    """
    if not spec.search:
        raise spec.refused("search", say('required by design: which keys vary, such as "control_unit.gain" = "0:1:21"'))
    axes = {path: values for path, values in spec.search.items() if path != SPRINGS}
    names = {path: values for path, values in axes.items() if keys()[path].about is None}
    parts = []
    for chosen in product(*names.values()):
        named = dict(zip(names, map(str, chosen), strict=True))
        variant = named.get("variant", spec.variant)
        taken = {
            path: values
            for path, values in axes.items()
            if path not in names and variant in (variants_of(path) or VARIANTS)
        }
        walls = [tuple(slope for slope in taken.get(SLOPE, ()) if bool(slope) == curved) for curved in (False, True)]
        parts += [(named, taken | {SLOPE: slopes}) for slopes in walls if slopes] or [(named, taken)]
    count = sum(math.prod(map(len, taken.values())) for _, taken in parts)
    if count > MOST:
        longest = max(axes, key=lambda path: len(axes[path]))
        message = say(
            "{count:,} candidates, at most {most:,} are searched: shorten this list, the longest, of {length:,} values",
            count=count, most=MOST, length=len(axes[longest]),
        )  # fmt: skip
        raise spec.refused(f"search.{longest}", message)
    return [
        Part(_base(spec, named, taken), named, {path: np.array(values, float) for path, values in taken.items()})
        for named, taken in parts
    ]


def _base(spec: Spec, named: Mapping[str, str], axes: Mapping[str, Sequence[Any]]) -> Spec:
    """Return the first valid spec among the candidates at the ends of all axes; without one, raise SpecError."""
    refused = None
    for ends in product(*(dict.fromkeys((values[0], values[-1])) for values in axes.values())):
        try:
            tried = candidate(spec, {**named, **dict(zip(axes, ends, strict=True))})
            build(tried)
        except SpecError as error:
            refused = refused or error
        else:
            return tried
    assert refused is not None
    raise refused


_IN_ORDER = (
    ("friction_group.driving_pairs", "friction_group.pairs"),
    ("friction_group.inner_radius", "friction_group.outer_radius"),
    ("envelope.bore", "envelope.hub_diameter"),
    ("envelope.hub_diameter", "envelope.outer_diameter"),
)
"""Pairs of spec keys; the value of the second key must be greater."""
_RANGES = ("friction", "friction.driving", "friction.driven")


def is_clutch(spec: Spec, own: Quantities) -> Any:
    """Mask of the candidates with a valid spec; one boolean if no number is an array."""
    good: Any = True
    for low, high in _IN_ORDER:
        less, more = value_at(spec, low), value_at(spec, high)
        if less is not None and more is not None:
            good &= less < more
    for path in _RANGES:
        ends = [value_at(spec, f"{path}.{end}") for end in ("min", "mean", "max")]
        known = [end for end in ends if end is not None]
        for less, more in zip(known, known[1:], strict=False):
            good &= less <= more
    if spec.kind.controlled:
        good &= spec.friction_group.pairs >= spec.least_pairs
    if spec.kind.travels:
        good &= own["net_gain"] >= 0
        if spec.control_unit is not None and spec.control_unit.pocket is not None:
            good &= own["friction_leaving"] > 0
    return good


# checks

WARNINGS = (
    "gain-above-limit", "reduced-gain-above-limit", "feedback-idle", "mean-pressure-in-range", "peak-pressure-in-range",
)  # fmt: skip
"""Codes of the warnings that exclude a candidate, as every error does."""
COLLIDE = Check("parts-collide", "", "", "m", "", TOUCHES)


def wired(spec: Spec) -> Quantities:
    """Return the quantities of a spec, numbers or arrays; a missing ball is the smallest ball that bears its force."""
    own, unit = build(spec), spec.control_unit
    if unit is None or unit.ball_diameter is not None or "contact_force" not in own:
        return own
    most: Any = (spec.requirements and spec.requirements.contact_pressure) or math.inf
    if unit.allowable_contact_force is None or unit.contact is not None:
        most = np.minimum(most, own["allowable_pressure"])
    if np.all(np.isinf(most)):
        return own
    chosen: Quantities = own
    ball = np.atleast_1d(own["ball_diameter_standard"])
    while True:  # the allowable force grows as the radius squared or more slowly, so that no ball is skipped
        borne = chosen["contact_force_hertz"] * (most / own["allowable_pressure"]) ** 3
        radius = chosen["ball_radius_chosen"] * np.sqrt(own["contact_force"] / borne)
        larger = np.maximum(ball, next_listed(2 * radius, own["balls_listed"]))
        if np.array_equal(larger, ball, equal_nan=True):
            return chosen
        chosen, ball = own.at(ball_diameter_standard=larger), larger


def rows_of(spec: Spec, own: Quantities) -> Iterator[Row]:
    """Yield the rows of all checks that can exclude a candidate and need no simulation or sample."""
    laid, known, unit = [], {}, spec.control_unit
    if spec.envelope is not None:  # if the spec gives no balls, with the chosen balls
        whole = spec
        if unit is not None and unit.ball_diameter is None and "ball_diameter_standard" in own:
            whole = with_values(spec, {"control_unit.ball_diameter": own["ball_diameter_standard"]})
        laid = parts_of(sizes_of(Clutch(whole, own.laws, own.given)))
        known = {"outer_diameter": 2 * laid[0].boxes[0].outer, "length": length_of(laid)}
    for check in checks_of(spec):
        if (check.level == "error" or check.code in WARNINGS) and check.needs in (None, "layout"):
            value, limit = (ask(known if check.needs else own) for ask in (check.value_of, check.limit_of))
            if value is not None and limit is not None:
                yield check, value, limit
    for *_, missing in overlaps(laid):
        yield COLLIDE, missing, TOUCHES


def holding(spec: Spec, own: Quantities, shape: tuple[int, ...]) -> Mask:
    """Mask of the clutches that have a valid spec and pass every check."""
    good = np.broadcast_to(is_clutch(spec, own), shape).copy()
    for check, value, limit in rows_of(spec, own):
        good &= check.passes(value, limit)
    return good


# survey and front


class Survey:
    """Candidates of the whole grid that pass every check, and counts of the checks that exclude the others."""

    def __init__(self, parts: Sequence[Part], objectives: Sequence[str]) -> None:
        """Evaluate the candidates of ``parts`` in blocks; keep the candidates that pass all checks, and objectives."""
        self.parts = parts
        self.candidates = sum(part.size for part in parts)
        self.excluded = Counter[str]()
        self.objectives = objectives
        self.nearest: tuple[tuple[int, float], dict[str, Any], float] | None = None
        """Candidate that fails the fewest checks, of several the one with the least excess: that, changes, ball."""
        self._places: list[tuple[Part, NDArray[np.intp], Numbers]] = []
        costs, done = [np.empty((0, len(objectives)))], 0
        for part in parts:
            for start in range(0, part.size, BLOCK):
                numbers = np.arange(start, min(start + BLOCK, part.size))
                costs.append(self._block(part, numbers))
                done += numbers.size
                tell(say("searching"), done, self.candidates)
        self.costs = np.concatenate(costs)
        self.feasible = len(self.costs)

    def _block(self, part: Part, numbers: NDArray[np.intp]) -> Numbers:
        """Keep the passing candidates of one block of the grid; return their objectives, one row per candidate."""
        values = part.values(numbers)
        spec = with_values(part.base, values)
        own = wired(spec)
        real = np.broadcast_to(is_clutch(spec, own), numbers.shape)
        lost = {"not-a-clutch": ~real}
        good, misses, excess = real.copy(), np.zeros(numbers.shape, int), np.zeros(numbers.shape)
        rows = list(rows_of(spec, own))
        for check, value, limit in rows:
            holds, name = np.broadcast_to(check.passes(value, limit), numbers.shape), name_of(check)
            beyond = np.abs(value - limit) / np.maximum(np.abs(limit), 1e-3)
            excess += np.where(holds, 0.0, np.nan_to_num(beyond, nan=1e9, posinf=1e9))
            misses += ~holds
            lost[name] = lost.get(name, False) | (~holds & real)
            good &= holds
        self.excluded.update({name: int(np.sum(mask)) for name, mask in lost.items()})
        chooses = spec.control_unit is not None and spec.control_unit.ball_diameter is None
        ball = np.broadcast_to(own.get("ball_diameter_standard", math.nan) if chooses else math.nan, numbers.shape)
        if real.any() and not good.any():
            best = int(np.lexsort((excess, np.where(real, misses, len(rows) + 1)))[0])
            rank = int(misses[best]), float(excess[best])
            if self.nearest is None or rank < self.nearest[0]:
                self.nearest = rank, part.changes(numbers[best]), float(ball[best])
        self._places.append((part, numbers[good], ball[good]))
        return np.stack([np.broadcast_to(cost(own, name), numbers.shape) for name in self.objectives], axis=1)[good]

    def changes(self, row: int) -> dict[str, Any]:
        """Path → value of the candidate in a row of ``costs``, with the ball chosen for it."""
        for part, numbers, balls in self._places:
            if row < len(numbers):
                return part.changes(numbers[row]) | with_ball(balls[row])
            row -= len(numbers)
        raise IndexError(row)


def with_ball(diameter: float) -> dict[str, float]:
    """Path → diameter of the ball chosen for a candidate; empty if the spec gives the ball, or none is large enough."""
    return {} if np.isnan(diameter) else {"control_unit.ball_diameter": float(diameter)}


def cost(own: Quantities, name: str) -> Any:
    """Return the values of an objective, negative for ``-name``; 0 if the clutch lacks it, infinite instead of NaN."""
    quantity = name.removeprefix("-")
    value = np.asarray(own.get(quantity, 0.0), float)
    return np.nan_to_num(-value if name.startswith("-") else value, nan=np.inf)


def unbeaten(costs: Numbers) -> list[int]:
    """Pareto front: indices of the rows that no other row dominates, in lexicographic order, equal rows once."""
    costs = _rounded(costs)
    left, kept = np.lexsort(costs.T[::-1]), []
    while left.size:
        first = left[0]
        kept.append(int(first))
        left = left[(costs[left] < costs[first]).any(axis=1)]
    return kept


def equal_to(costs: Numbers, kept: Sequence[int]) -> int:
    """Number of rows that are not in ``kept`` but equal a row in ``kept``."""
    rows = [tuple(row) for row in _rounded(costs).tolist()]
    return sum(Counter(rows)[rows[place]] - 1 for place in kept)


def _rounded(values: Numbers) -> Numbers:
    """Values rounded to ``_DIGITS``, so that equal clutches compare equal in spite of rounding errors."""
    share, exponent = np.frexp(values)
    return np.ldexp(np.round(share, _DIGITS), exponent)
