"""Results whose fields are filled with quantities of the clutch; cache of the analyses of a clutch."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import Any, ClassVar, NamedTuple, TypeVar, get_args

from pydantic import create_model

from ..engines import Clutch, build
from ..engines.quantities import Quantities
from ..equations.terms import DETAILS, term_of
from ..errors import AfmcalcError
from ..findings import Finding
from ..result import Result, Triple, shown_as
from ..result import quantity as declared
from .registry import ANALYSES, StressRule

R = TypeVar("R", bound=Result)
ENDS = ("f_min", "f_mean", "f_max")
"""Cases in which the three numbers of a ``Triple`` are calculated."""


class Asking(Result):
    """Base class of results with ``asked`` fields, whose values are quantities of the clutch."""

    details_of: ClassVar[str] = ""
    """Command whose detail quantities (``DETAILS`` in ``equations.terms``) are the extra fields for ``--details``."""
    details_are: ClassVar[type] = float
    """Type of the extra fields; ``Triple`` also allows one number, for a quantity that does not depend on friction."""

    @classmethod
    @cache
    def detailed(cls) -> Any:
        """Return the class with an optional field for each detail quantity; without any, the class itself."""
        names = [name for name, command in DETAILS.items() if command == cls.details_of]
        kind = cls.details_are | float | None
        fields: dict[str, Any] = {name: (kind, asked(optional=True, details=True)) for name in names}
        return create_model(cls.__name__, __base__=cls, __doc__=cls.__doc__, **fields) if names else cls

    @classmethod
    def __pydantic_init_subclass__(cls, **options: Any) -> None:
        """Give each ``asked`` field the symbol, unit and meaning of its quantity."""
        for name, field in cls.model_fields.items():
            if (shown := shown_as(field)).asked:
                term = term_of(shown.quantity or name)
                field.json_schema_extra = replace(
                    shown, unit=term.unit, symbol=shown.symbol or term.symbol, quantity=shown.quantity or name
                )
                field.description = field.description or term.meaning


def asked(
    quantity: str = "", description: str = "", *, symbol: str | None = None, optional: bool = False, **shown: Any
) -> Any:
    """Declare a field for the value of a quantity; unit, symbol and meaning come from ``equations.terms``.

    Args:
        quantity: name of the quantity, if it is not the name of the field.
        description: meaning, if its words are to differ from those in ``equations.terms``.
        symbol: symbol, if it differs from ``equations.terms``.
        optional: leave the field null (and out of tables) if the quantity cannot be calculated from the spec.
        shown: further arguments of ``Shown``.
    """
    return declared("", symbol, description, optional=optional, asked=True, quantity=quantity, **shown)


class _Question(NamedTuple):
    field: str
    names: tuple[str, ...]
    """Names of the quantities: one name, or the three names for a ``Triple``."""
    optional: bool
    alone: str = ""
    """Name to use instead of the three names if the quantity does not depend on friction; else empty."""


@cache
def _questions(kind: type[Result]) -> list[_Question]:
    """Names of the quantities that fill the ``asked`` fields of a result, one ``_Question`` for each field."""
    questions = []
    for field, info in kind.model_fields.items():
        if (shown := shown_as(info)).asked:
            types = (info.annotation, *get_args(info.annotation))
            over_range, alone = Triple in types, shown.quantity if Triple in types and float in types else ""
            names = tuple(f"{shown.quantity}_at_{case}" for case in ENDS) if over_range else (shown.quantity,)
            questions.append(_Question(field, names, not info.is_required(), alone))
    return questions


def answer(kind: type[R], clutch: Quantities, **values: Any) -> R:
    """Return a result with its ``asked`` fields filled with the quantities of a clutch, or of a case of it.

    Args:
        kind: class of the result. A ``Triple`` takes values of the cases f_min, f_mean and f_max; an optional field is
            null if the clutch has no such quantity (``clutch.missing(name)`` says why).
        clutch: clutch, or case of a clutch, whose quantities fill the fields.
        values: values of the fields that are not ``asked``, and values that replace those of ``asked`` fields.
    """
    detailed = kind.detailed()
    questions = [question for question in _questions(detailed) if question.field not in values]
    known = clutch.known([name for question in questions for name in (question.alone, *question.names) if name])
    for field, asked_names, optional, alone in questions:
        names = (alone,) if alone in known else asked_names
        if optional and names[0] not in known:
            continue
        own = [known[name] if name in known else clutch[name] for name in names]  # clutch[…] says what is missing
        values[field] = Triple(min=own[0], mean=own[1], max=own[2]) if len(own) > 1 else own[0]
    return detailed(**values)


def asked_by(kind: type[Result], clutch: Quantities) -> dict[str, str]:
    """Return field → quantity for those ``asked`` fields of a result whose quantities the clutch has."""
    names = {question.field: question.names[0] for question in _questions(kind)}
    return {field: name for field, name in names.items() if name in clutch}


def with_columns(kind: type[R], clutch: Quantities, names: Iterable[str]) -> type[R]:
    """Return the class of a sweep with a further column for each quantity in ``names``, such as ``torque_at_f_max``.

    Raises AfmcalcError if the clutch lacks one of the quantities, or if a quantity is not a number.
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
    """Cache of the analyses of one clutch; each analysis runs when its result is first needed.

    If the clutch notes its steps (``explain``), analyses that are not explained run on a copy that notes no steps.
    """

    def __init__(self, clutch: Clutch, *, model: StressRule = "mean-stress", quiet: "Answers | None" = None) -> None:
        """Start an empty cache; ``model``: rule for the damaging stress; ``quiet``: existing cache of the copy."""
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
        """Return the result of the class ``kind``; its analysis runs now if it has not run yet."""
        name = next(each.name for each in ANALYSES.values() if each.result == kind.__name__)
        return self.ask(name)[0]

    @property
    def quiet(self) -> Clutch:
        """The clutch or, if it notes its steps, its copy that notes no steps."""
        return self._quiet.clutch
