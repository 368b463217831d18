"""Calls in the order of a calculation: what a formula uses before the formula."""

from collections.abc import Iterable, Mapping

from .trace import Call, Marked


def in_order(calls: Iterable[Call]) -> list[list[Call]]:
    """Return calls by equation: what a call uses before it, and else in the order in which the equations ran.

    A group is parted where it must: κ leads to the sleeve's place, and is taken anew there.
    """
    left, found = dict[str, list[Call]](), list[list[Call]]()
    for call in calls:
        left.setdefault(call.equation.name, []).append(call)
    known = _results(left)
    while left:
        missing = _results(left)
        ready = {name: [call for call in calls if not _uses(call, known) & missing] for name, calls in left.items()}
        whole = (name for name in left if len(ready[name]) == len(left[name]))
        name = next(whole, next((name for name in left if ready[name]), next(iter(left))))
        found.append(part := ready[name] or left[name])
        left[name] = [call for call in left[name] if not any(call is each for each in part)]
        left = {own: calls for own, calls in left.items() if calls}
    return found


def _results(groups: Mapping[str, list[Call]]) -> set[tuple[str, str]]:
    """Equations with their values, and without."""
    return {(name, own) for name, calls in groups.items() for call in calls for own in ("", f"{call.value:.12g}")}


def _uses(call: Call, known: set[tuple[str, str]]) -> set[tuple[str, str]]:
    """Results of other equations that a call uses; of one that a search found, all of its equation."""
    marks = [value for value in call.arguments.values() if isinstance(value, Marked)]
    own = {(value.origin, f"{value:.12g}") for value in marks if value.origin != call.equation.name}
    return {each if each in known else (each[0], "") for each in own}
