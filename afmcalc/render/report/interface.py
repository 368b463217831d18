"""What a report is made from, and what its sections are made of."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ...analysis.dossier import Dossier
from ...engines.protocol import Clutch
from ...findings import Finding
from ..layout import Block
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
    """The clutch a report is about, and what was found of it."""

    clutch: Clutch
    dossier: Dossier
    findings: Sequence[Finding]
    given: str
    """The spec as given, its text."""
    overrides: Sequence[str] = ()
    """``PATH=VALUE`` put over it."""
    version: str = ""
    date: str = ""
    model: str = "mean-stress"
    steps: Mapping[str, Sequence[ExplainedStep]] = field(default_factory=dict)
    """Section key (``torque``, ``accuracy``, …) → its calculation, explained."""
    results: Mapping[str, Any] = field(default_factory=dict)
    """Results beyond the dossier, by section key (``tolerance``: a ``Study``)."""


@dataclass(frozen=True)
class Section:
    """One calculation of the report."""

    key: str
    title: str
    about: str
    blocks: Sequence[Block] = ()
    sheets: Sequence[Sheet] = ()
    sources: Sequence[str] = ()
    """Keys of the references it rests on."""
