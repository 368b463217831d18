"""An analysis is a list of quantities: the fields of its result ask a clutch for them, each by its own name."""

from functools import cache
from typing import Any, NamedTuple, TypeVar, get_args

from ..engines.quantities import Quantities
from ..result import Result, Triple, shown_as

R = TypeVar("R", bound=Result)
ENDS = {"f_min": "min", "f_mean": "mean", "f_max": "max"}
"""Case of a friction → its place in a ``Triple``."""


class _Question(NamedTuple):
    field: str
    quantity: str
    over_range: bool
    """Whether it is asked at the smallest, the mean and the largest friction."""
    optional: bool


@cache
def _questions(kind: type[Result]) -> list[_Question]:
    return [
        _Question(
            name,
            shown.quantity,
            over_range=Triple in (field.annotation, *get_args(field.annotation)),
            optional=not field.is_required(),
        )
        for name, field in kind.model_fields.items()
        if (shown := shown_as(field)).asked
    ]


def answer(kind: type[R], clutch: Quantities, **values: Any) -> R:
    """Return a result whose fields that are ``asked`` have the quantities of a clutch, or of a case of it.

    Args:
        kind: class of the result. A ``Triple`` is asked in the cases f_min, f_mean and f_max; an optional field is null
            where the clutch has no such quantity (``clutch.missing(name)`` says why).
        clutch: the quantities.
        values: the fields that are not asked, and those of the others that are something else here.
    """
    for field, name, over_range, optional in _questions(kind):
        if field in values or (optional and (f"{name}_at_f_min" if over_range else name) not in clutch):
            continue
        values[field] = over_ends(clutch, name) if over_range else clutch[name]
    return kind(**values)


def over_ends(clutch: Quantities, name: str) -> Triple:
    """Return a quantity at the smallest, the mean and the largest friction."""
    return Triple(**{end: clutch[f"{name}_at_{case}"] for case, end in ENDS.items()})
