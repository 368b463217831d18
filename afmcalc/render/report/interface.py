"""What a report is made from, and what its chapters are made of."""

from collections.abc import Sequence
from dataclasses import dataclass

from ...analysis.dossier import Dossier
from ..layout import TextTable
from ..plot.chart import Sheet


@dataclass(frozen=True)
class ExplainedStep:
    """One quantity as an engineer writes it: formula, the same with numbers, result, source."""

    title: str
    symbol: str
    formula: str
    """Presentation MathML, a ``<math>`` element; empty where the step before has shown it."""
    numbers: str
    """The formula with numbers and units put in, and the value, MathML."""
    source: str
    """Where the formula is from, such as ``F11 (12)``."""
    note: str = ""
    """Where the paper's print differs."""


@dataclass(frozen=True)
class Subject:
    """What was found of a clutch, and whose report it is."""

    dossier: Dossier
    given: str
    """The spec as given, its text."""
    overrides: Sequence[str] = ()
    """``PATH=VALUE`` put over it."""
    version: str = ""
    date: str = ""


@dataclass(frozen=True)
class Chapter:
    """One calculation of the report."""

    key: str
    title: str
    about: str
    blocks: Sequence[TextTable]
    steps: Sequence[ExplainedStep]
    sheets: Sequence[Sheet]
    sources: Sequence[str]
    """Keys of the references it rests on."""
