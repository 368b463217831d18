"""Answers of one clutch, each calculated once."""

from functools import cached_property
from typing import Any, TypeVar

from ..engines import Clutch, build
from ..findings import Finding
from ..result import Result
from .registry import ANALYSES, StressRule

R = TypeVar("R", bound=Result)


class Answers:
    """A clutch with the answers to what was asked of it; each is calculated when first asked for, and kept.

    Of a clutch that notes its steps (``explain``) an analysis that is not explained asks another, which does not.
    """

    def __init__(self, clutch: Clutch, *, model: StressRule = "mean-stress") -> None:
        """Ask of ``clutch``, the life by ``model``."""
        self.clutch, self.model = clutch, model
        self._options = {"model": model, "answers": self}
        self._answers: dict[str, tuple[Any, list[Finding]]] = {}

    def ask(self, name: str) -> tuple[Any, list[Finding]]:
        """Return result and findings of an analysis, run at most once."""
        if name not in self._answers:
            analysis = ANALYSES[name]
            options = {option: self._options[option] for option in analysis.options}
            clutch = self.clutch if analysis.explained else self.quiet
            self._answers[name] = analysis.function(clutch, **options)
        return self._answers[name]

    def of(self, kind: type[R]) -> R:
        """Return the result of that class."""
        name = next(each.name for each in ANALYSES.values() if each.result == kind.__name__)
        return self.ask(name)[0]

    @cached_property
    def quiet(self) -> Clutch:
        """The clutch without notes of its steps."""
        return self.clutch if self.clutch.steps is None else build(self.clutch.spec)
