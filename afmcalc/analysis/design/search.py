"""Search of the whole discrete space: how many candidates are feasible, what excludes the others, and the front."""

from collections.abc import Callable

from ...spec.requirements import Requirements
from ...variants import VARIANTS
from .found import Found
from .radius import by_radius, separable
from .tiles import by_tile

_MANY = 48
"""Mean radii from which looking them up is quicker than trying them."""


def search(need: Requirements, progress: Callable[[int], None] = lambda done: None) -> Found:
    """Go through the whole space; ``progress`` is told how many candidates are behind."""
    found = Found()
    for variant in (VARIANTS[name] for name in dict.fromkeys(need.variants)):
        looked_up = separable(need, variant) and need.search.radii.size >= _MANY
        (by_radius if looked_up else by_tile)(need, variant, found, progress)
    found.settle()
    return found
