"""What a report is made from, and what its chapters are made of."""

from collections.abc import Sequence
from dataclasses import dataclass

from ...analysis.dossier import Dossier
from ...spec.report import TitleBlock
from ..layout import TextTable
from ..plot.chart import Sheet
from .steps import Derived


@dataclass(frozen=True)
class Subject:
    """What was found of a clutch, and whose report it is."""

    dossier: Dossier
    given: str
    """The spec as given, its text."""
    title: TitleBlock = TitleBlock()
    """What the title block says; without a date it has none."""
    digest: str = ""
    """SHA-256 of the file as given."""
    source: str = ""
    """Where the spec was read."""
    overrides: Sequence[str] = ()
    """``PATH=VALUE`` put over it."""
    version: str = ""


@dataclass(frozen=True)
class Chapter:
    """One calculation of the report."""

    key: str
    title: str
    about: str
    tables: Sequence[TextTable]
    blocks: Sequence[Derived]
    sheets: Sequence[Sheet]
    sources: Sequence[str]
    """Keys of the references it rests on."""
