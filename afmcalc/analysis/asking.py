"""An analysis is a list of quantities: the fields of its result ask a clutch for them, each by its own name."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple, TypeVar, get_args

from pydantic import Field, create_model

from ..engines import Clutch, build
from ..engines.quantities import Quantities
from ..equations.terms import term_of
from ..errors import AfmcalcError
from ..findings import Finding
from ..result import Result, Shown, Triple, shown_as
from .registry import ANALYSES, StressRule

R = TypeVar("R", bound=Result)
ENDS = ("f_min", "f_mean", "f_max")
"""Cases of a ``Triple``."""


class Asking(Result):
    """Base of a result with fields that are ``asked``."""

    @classmethod
    def __pydantic_init_subclass__(cls, **options: Any) -> None:
        """Give each field that is ``asked`` symbol, unit and meaning of its quantity."""
        for name, field in cls.model_fields.items():
            if (shown := shown_as(field)).asked:
                term = term_of(shown.quantity or name)
                field.json_schema_extra = replace(
                    shown, unit=term.unit, symbol=shown.symbol or term.symbol, quantity=shown.quantity or name
                )
                field.description = field.description or term.meaning


def asked(quantity: str = "", description: str = "", *, optional: bool = False, **shown: Any) -> Any:
    """Declare a field that has the value of a quantity: unit, symbol and meaning are those of ``equations.terms``.

    Args:
        quantity: name of the quantity, where it is not that of the field.
        description: what it is, where the result has other words for it than the terms.
        optional: leave the field null (and out of tables) where the quantity does not follow from what is given.
        shown: the rest, as ``Shown``; a ``symbol`` where the result has another one than the terms.
    """
    about = Shown(asked=True, quantity=quantity, **shown)
    if optional:
        return Field(default=None, description=description or None, json_schema_extra=about)
    return Field(description=description or None, json_schema_extra=about)


class _Question(NamedTuple):
    field: str
    names: tuple[str, ...]
    """One, or three of a ``Triple``."""
    optional: bool


@cache
def _questions(kind: type[Result]) -> list[_Question]:
    """Questions that the fields of a result ask."""
    questions = []
    for field, info in kind.model_fields.items():
        if (shown := shown_as(info)).asked:
            over_range = Triple in (info.annotation, *get_args(info.annotation))
            names = tuple(f"{shown.quantity}_at_{case}" for case in ENDS) if over_range else (shown.quantity,)
            questions.append(_Question(field, names, optional=not info.is_required()))
    return questions


def answer(kind: type[R], clutch: Quantities, **values: Any) -> R:
    """Return a result whose fields that are ``asked`` have the quantities of a clutch, or of a case of it.

    Args:
        kind: class of the result. A ``Triple`` is asked in the cases f_min, f_mean and f_max; an optional field is null
            where the clutch has no such quantity (``clutch.missing(name)`` says why).
        clutch: the quantities.
        values: the fields that are not asked, and those of the others that are something else here.
    """
    questions = [question for question in _questions(kind) if question.field not in values]
    known = clutch.known([name for question in questions for name in question.names])
    for field, names, optional in questions:
        if optional and names[0] not in known:
            continue
        own = [known[name] if name in known else clutch[name] for name in names]  # clutch[…] says what is missing
        values[field] = Triple(min=own[0], mean=own[1], max=own[2]) if len(own) > 1 else own[0]
    return kind(**values)


def asked_by(kind: type[Result], clutch: Quantities) -> dict[str, str]:
    """Return what the fields of a result, of a sweep say, ask of a clutch: field → quantity, of those that it has."""
    names = {question.field: question.names[0] for question in _questions(kind)}
    return {field: name for field, name in names.items() if name in clutch}


def with_columns(kind: type[R], clutch: Quantities, names: Iterable[str]) -> type[R]:
    """Return the class of a sweep with a column for each of some quantities, such as ``torque_at_f_max``.

    Raises AfmcalcError: the clutch has no such quantity, or one that is no number.
    """
    wanted = [name for name in names if name not in kind.model_fields]
    for name in wanted:
        try:
            value = clutch[name]
        except LookupError as error:
            raise AfmcalcError("--columns {name}: {why}", name=name, why=error.args[0]) from None
        if not isinstance(value, int | float):
            raise AfmcalcError("--columns {name}: is no number", name=name)
    columns: dict[str, Any] = {name: (list[float | None], asked()) for name in wanted}
    return create_model(kind.__name__, __base__=kind, **columns) if columns else kind


class Answers:
    """Cache of the analyses of one clutch, each run when it is first asked for.

    Where the clutch notes its steps (``explain``), analyses that are not explained run on a copy that notes none.
    """

    def __init__(self, clutch: Clutch, *, model: StressRule = "mean-stress", quiet: "Answers | None" = None) -> None:
        """Begin with no analysis run; ``model`` is the rule of the life, ``quiet`` the answers of that copy."""
        self.clutch, self.model = clutch, model
        self._quiet = quiet or (self if clutch.steps is None else Answers(build(clutch.spec), model=model))
        self._options = {"model": model, "answers": self}
        self._answers: dict[str, tuple[Any, list[Finding]]] = {}

    def ask(self, name: str) -> tuple[Any, list[Finding]]:
        """Return result and findings of an analysis, run at most once."""
        analysis = ANALYSES[name]
        if not analysis.explained and self._quiet is not self:
            return self._quiet.ask(name)
        if name not in self._answers:
            options = {option: self._options[option] for option in analysis.options}
            self._answers[name] = analysis.function(self.clutch, **options)
        return self._answers[name]

    def of(self, kind: type[R]) -> R:
        """Return the result of that class."""
        name = next(each.name for each in ANALYSES.values() if each.result == kind.__name__)
        return self.ask(name)[0]

    @property
    def quiet(self) -> Clutch:
        """The clutch without notes of its steps."""
        return self._quiet.clutch
