"""The grid of a search: its candidates, each check as a mask over them, and the front of those that hold all."""

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
from ..engines.rings import TOUCHES, SectionPart, length_of, overlaps, parts_of, sizes_of
from ..equations.arrays import next_listed
from ..errors import SpecError
from ..messages import deferred, say
from ..progress import tell
from ..spec import Spec, make_spec, resolved
from ..spec.edit import value_at, with_values, without_replaced
from ..spec.keys import keys
from ..spec.read import put
from ..spec.rules import given_in
from ..spec.search import MOST, SPRINGS
from ..variants import foreign_keys, variants_of

Numbers = NDArray[np.float64]
Mask = NDArray[np.bool_]
_DIGITS = 11
"""Digits of an objective that tell two clutches apart."""


class Row(NamedTuple):
    """A check of many candidates, with their values and limits."""

    check: Check
    value: Any
    limit: Any

    @property
    def holds(self) -> Any:
        """True if each candidate holds it; on the limit it does."""
        return self.check.passes(self.value, self.limit)

    @property
    def excess(self) -> Any:
        """Excess of each, as a share of the limit; 0 where it holds."""
        size = np.maximum(np.abs(self.limit), 1e-3)
        beyond = np.nan_to_num(np.abs(self.value - self.limit) / size, nan=1e9, posinf=1e9)
        return np.where(self.holds, 0.0, beyond)

    def at(self, place: int) -> "Row":
        """Return the row of one candidate."""
        value, limit = (float(np.ravel(one)[place if np.size(one) > 1 else 0]) for one in (self.value, self.limit))
        return self._replace(value=value, limit=limit)


def name_of(check: Check) -> str:
    """Return what a check is counted as: the key of its requirement, or its code."""
    return check.requirement or check.code.partition("/")[0]


class Part(NamedTuple):
    """The candidates that differ in numbers alone."""

    base: Spec
    """One of them."""
    names: dict[str, str]
    """Path → variant, material or other name."""
    axes: dict[str, Numbers]

    @property
    def size(self) -> int:
        """Number of candidates."""
        return math.prod(len(values) for values in self.axes.values())

    def values(self, numbers: NDArray[np.intp]) -> dict[str, Numbers]:
        """Path → the values of the candidates of some numbers."""
        places = np.unravel_index(numbers, tuple(len(values) for values in self.axes.values()) or (1,))
        return {path: values[place] for (path, values), place in zip(self.axes.items(), places, strict=False)}


def parts_of_search(spec: Spec) -> list[Part]:
    """Return the parts of the grid of a search, one for each combination of names.

    Raises SpecError: no [search], more candidates than are searched, or a combination of which no candidate is a spec.
    """
    if not spec.search:
        raise spec.refused("search", say('required by design: which keys vary, such as "control_unit.gain" = "0:1:21"'))
    axes = {path: values for path, values in spec.search.items() if path != SPRINGS}
    names = {path: values for path, values in axes.items() if keys()[path].about is None}
    parts = []
    for chosen in product(*names.values()):
        named = dict(zip(names, map(str, chosen), strict=True))
        variant = named.get("variant", spec.variant)
        taken = {path: values for path, values in axes.items() if path not in names and _takes(variant, path)}
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


def _takes(variant: str, path: str) -> bool:
    having = variants_of(path)
    return not having or variant in having


def candidate(spec: Spec, changes: Mapping[str, Any]) -> Spec:
    """Return the spec of a candidate: with other values of some keys, without what its variant does not have.

    Raises SpecError: there is no such clutch.
    """
    data = resolved(without_replaced(spec, changes)) | {"search": None}
    for path, value in changes.items():
        put(data, path, value)
    for path in foreign_keys(given_in(data), data["variant"]):
        put(data, path, None)
    return make_spec(data, spec.label.but(changes))


def _base(spec: Spec, named: Mapping[str, str], axes: Mapping[str, Sequence[Any]]) -> Spec:
    """Return the first candidate that is a spec, of those at the ends of the axes."""
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
"""Keys of which the second is greater."""
_RANGES = ("friction", "friction.driving", "friction.driven")


def is_clutch(spec: Spec, own: Quantities) -> Any:
    """True if each candidate is one that a spec may describe; its numbers may be arrays."""
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

_WARNINGS = (
    "gain-above-limit", "reduced-gain-above-limit", "feedback-idle", "mean-pressure-in-range", "peak-pressure-in-range",
)  # fmt: skip
"""Warnings that exclude a candidate as errors do."""
COLLIDE = Check("parts-collide", deferred("overlap of two parts"), "", "m", "", TOUCHES, path="envelope")


def wired(spec: Spec) -> Quantities:
    """Return the quantities of a spec, whose numbers may be arrays; a ball not given is one that bears its force."""
    own, unit = build(spec), spec.control_unit
    if unit is None or unit.ball_diameter is not None or "contact_force" not in own or "path_steepening" in own:
        return own
    most: Any = (spec.requirements and spec.requirements.contact_pressure) or math.inf
    if unit.allowable_contact_force is None or unit.contact is not None:
        most = np.minimum(most, own["allowable_pressure"])
    if np.all(np.isinf(most)):
        return own
    borne = own["contact_force_hertz"] * (most / own["allowable_pressure"]) ** 3
    radius = np.maximum(own["ball_radius_chosen"] * np.sqrt(own["contact_force"] / borne), own["ball_radius"])
    return own.at(ball_diameter_standard=next_listed(2 * np.atleast_1d(radius), own["balls_listed"]))


def rows_of(spec: Spec, own: Quantities) -> Iterator[Row]:
    """Yield the checks that can be asked of many clutches at once."""
    laid = None if spec.envelope is None else _layout(spec, own)
    known = {} if laid is None else {"outer_diameter": 2 * laid[0].boxes[0].outer, "length": length_of(laid)}
    for check in checks_of(spec):
        if (check.level == "error" or check.code in _WARNINGS) and check.needs in (None, "layout"):
            value, limit = (ask(known if check.needs else own) for ask in (check.value_of, check.limit_of))
            if value is not None and limit is not None:
                yield Row(check, value, limit)
    for first, second, missing in overlaps(laid or []):
        yield Row(COLLIDE._replace(value=f"{first}/{second}"), missing, TOUCHES)


def holding(spec: Spec, own: Quantities, shape: tuple[int, ...]) -> Mask:
    """True if each of many clutches is one, and holds every check."""
    good = np.broadcast_to(is_clutch(spec, own), shape).copy()
    for row in rows_of(spec, own):
        good &= row.holds
    return good


def _layout(spec: Spec, own: Quantities) -> list[SectionPart]:
    """Lay out the clutches with the balls chosen."""
    unit = spec.control_unit
    if unit is not None and unit.ball_diameter is None and "ball_diameter_standard" in own:
        spec = with_values(spec, {"control_unit.ball_diameter": own["ball_diameter_standard"]})
    return parts_of(sizes_of(Clutch(spec, own.laws, own.given)))


# survey and front


class Nearest(NamedTuple):
    """The candidate that misses the fewest checks, by the least."""

    rank: tuple[int, float]
    """Number of checks that it misses, and by how much."""
    changes: dict[str, Any]
    row: Row
    """Check that it misses by the most."""


class Survey:
    """Candidates of the whole grid that hold every check, and what excludes the others."""

    def __init__(self, parts: Sequence[Part], objectives: Sequence[str]) -> None:
        """Look through the grid of a search."""
        self.parts = parts
        self.candidates = sum(part.size for part in parts)
        self.excluded = Counter[str]()
        self.objectives = objectives
        self.nearest: Nearest | None = None
        self._places: list[tuple[int, NDArray[np.intp]]] = []
        costs, done = [np.empty((0, len(objectives)))], 0
        for place, part in enumerate(self.parts):
            for start in range(0, part.size, BLOCK):
                numbers = np.arange(start, min(start + BLOCK, part.size))
                good, cost = self._block(part, numbers)
                self._places.append((place, numbers[good]))
                costs.append(cost)
                done += numbers.size
                tell(say("searching"), done, self.candidates)
        self.costs = np.concatenate(costs)
        self.feasible = len(self.costs)

    def _block(self, part: Part, numbers: NDArray[np.intp]) -> tuple[Mask, Numbers]:
        values = part.values(numbers)
        spec = with_values(part.base, values)
        own = wired(spec)
        real = np.broadcast_to(is_clutch(spec, own), numbers.shape)
        lost = {"not-a-clutch": ~real}
        good, misses, excess = real.copy(), np.zeros(numbers.shape, int), np.zeros(numbers.shape)
        rows = list(rows_of(spec, own))
        for row in rows:
            holds = np.broadcast_to(row.holds, numbers.shape)
            misses += ~holds
            excess += row.excess
            name = name_of(row.check)
            lost[name] = lost.get(name, False) | (~holds & real)
            good &= holds
        self.excluded.update({name: int(np.sum(mask)) for name, mask in lost.items()})
        if real.any() and not good.any():
            self._near(part, values, rows, np.where(real, misses, len(rows) + 1), excess)
        columns = [np.broadcast_to(cost(own, name), numbers.shape) for name in self.objectives]
        return good, np.stack(columns, axis=1)[good] if columns else np.empty((int(good.sum()), 0))

    def _near(self, part: Part, values: dict[str, Numbers], rows: list[Row], misses: Any, excess: Numbers) -> None:
        best = int(np.lexsort((excess, misses))[0])
        rank = int(misses[best]), float(excess[best])
        if self.nearest is None or rank < self.nearest.rank:
            changes = part.names | {path: own[best] for path, own in values.items()}
            self.nearest = Nearest(rank, changes, max((row.at(best) for row in rows), key=lambda one: one.excess))

    def changes(self, row: int) -> dict[str, Any]:
        """Path → value of a feasible candidate, numbers as they were typed; with the ball chosen."""
        for place, numbers in self._places:
            if row < len(numbers):
                part = self.parts[place]
                values = part.values(numbers[row : row + 1])
                if value_at(part.base, _BALL) is None and part.base.control_unit is not None:
                    ball = wired(with_values(part.base, values)).get("ball_diameter_standard", np.nan)
                    values |= {} if np.isnan(ball).any() else {_BALL: np.ravel(ball)}
                return part.names | {path: _typed(path, own[0]) for path, own in values.items()}
            row -= len(numbers)
        raise IndexError(row)


_BALL = "control_unit.ball_diameter"


def _typed(path: str, value: Any) -> float:
    about = keys()[path].about
    return int(value) if about is not None and about.whole else float(value)


def cost(own: Quantities, name: str) -> Any:
    """Return an objective such that less is better, with a minus the most; what is not there costs nothing."""
    quantity = name.removeprefix("-")
    value = np.asarray(own.get(quantity, 0.0), float)
    return np.nan_to_num(-value if name.startswith("-") else value, nan=np.inf)


def unbeaten(costs: Numbers) -> list[int]:
    """Rows that no other beats: in order, each survivor removes what it beats; of equal ones the first stays."""
    costs = _rounded(costs)
    left, kept = np.lexsort(costs.T[::-1]), []
    while left.size:
        first = left[0]
        kept.append(int(first))
        left = left[(costs[left] < costs[first]).any(axis=1)]
    return kept


def equal_to(costs: Numbers, kept: Sequence[int]) -> int:
    """Number of other rows that equal one of those kept."""
    rows = [tuple(row) for row in _rounded(costs).tolist()]
    return sum(Counter(rows)[rows[place]] - 1 for place in kept)


def _rounded(values: Numbers) -> Numbers:
    """Values without their last digits, by which clutches differ that are the same."""
    share, exponent = np.frexp(values)
    return np.ldexp(np.round(share, _DIGITS), exponent)
