"""Plots as data in SI: a sheet of panels, each with its axes, lines, points and guides."""

import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from ...messages import RAISED, filled, localized, translate
from ...result import Result, shown_as
from ..amounts import converted, headed, measured


class ChartAxis(NamedTuple):
    """One axis of a chart: quantity, symbol, SI unit."""

    quantity: str
    symbol: str
    unit: str = "1"

    @property
    def label(self) -> str:
        """Quantity, symbol and the engineer's unit."""
        return headed(f"{self.quantity} {self.symbol}".strip(), self.unit)

    def shown(self, values: Iterable[float | None]) -> list[float]:
        """Return values in the engineer's unit, NaN in place of None."""
        return [math.nan if value is None else converted(value, self.unit) for value in values]


class Line(NamedTuple):
    """A curve; it has a gap where a value is None."""

    label: str
    x: Sequence[float | None]
    y: Sequence[float | None]
    style: int | None = None
    """Index of the line style; None: the next style."""
    points: bool = False
    """True for markers without a line."""
    filled: bool = False
    """True for filled markers, which stand out; False for open markers."""
    names: Sequence[str] = ()
    """Names of the points; only the names of the first and the last point are drawn."""


class Guide(NamedTuple):
    """Straight line across the axes, at a value of x or of y."""

    label: str
    value: float
    across: bool = True
    """True for a horizontal line at a value of y, False for a vertical line at a value of x."""
    tag: str = ""
    """Short name above the axes, for a vertical line."""
    style: int | None = None
    """Index of the guide style; None: the next style."""


class Area(NamedTuple):
    """A shaded region between two curves."""

    label: str
    x: Sequence[float]
    low: Sequence[float]
    high: Sequence[float]


class Chart(NamedTuple):
    """One pair of axes."""

    x: ChartAxis
    y: ChartAxis
    lines: list[Line]
    title: str = ""
    guides: Sequence[Guide] = ()
    areas: Sequence[Area] = ()
    log: bool = False
    """True if the y axis is logarithmic."""
    from_zero: bool = False
    """True if the y axis begins at 0."""
    bounds: tuple[float, float, float, float] | None = None
    """Limits of the x axis, then of the y axis; None: the limits of the data."""
    named: bool = False
    """True if the labels of the lines are names given by the user, which are set unchanged."""

    @property
    def labels(self) -> list[str]:
        """Entries of the legend."""
        return [entry.label for entries in (self.areas, self.lines, self.guides) for entry in entries if entry.label]


class Sheet(NamedTuple):
    """Drawing of one plot command: panels one below the other, title above, caption below."""

    title: str
    panels: Sequence[Any]
    """Charts, or one ``Drawing``."""
    caption: str = ""
    name: str | None = None
    """Name of a spec, beside the title; set unchanged."""
    aside: str = ""
    """Further caption of a drawing that stands alone, outside a report."""

    @property
    def below(self) -> str:
        """Text below the drawing where it stands alone."""
        return f"{self.caption} {self.aside}".strip()


def axis_of(record: Result, name: str, *, quantity: str | None = None) -> ChartAxis:
    """Axis for a field of a result, labelled with symbol, unit and description of the field."""
    field = type(record).model_fields[name]
    shown = shown_as(field)
    return ChartAxis(quantity or translate(field.description or name), shown.symbol or "", shown.unit)


def line_of(record: Result, name: str, x: Sequence[float | None], **how: Any) -> Line:
    """Line of a field that has a list, labelled with its symbol and description; ``how``: arguments of ``Line``."""
    axis = axis_of(record, name)
    return Line(f"{axis.symbol}: {axis.quantity}", x, getattr(record, name), **how)


def power(value: float) -> str:
    """Write a large number as a power of ten.

    >>> power(1e7), power(2.5e12)
    ('10⁷', '2.5·10¹²')
    """
    mantissa, _, exponent = f"{value:.3e}".partition("e")
    ten = "10" + str(int(exponent)).translate(RAISED)
    return ten if float(mantissa) == 1 else f"{localized(f'{float(mantissa):g}')}·{ten}"


def stated(symbol: str, value: float, unit: str) -> str:
    """``symbol = value unit`` in the engineer's unit.

    >>> stated("F_п", 2000.0, "N"), stated("C", 0.5, "1")
    ('F_п = 2 kN', 'C = 0.5')
    """
    return f"{symbol} = {measured(value, unit)}"


def guide_at(text: str, symbol: str, value: float, unit: str, *, across: bool = True) -> Guide:
    """Guide at a value, with the label ``text``, in which ``{stated}`` is replaced by symbol, value and unit."""
    return Guide(filled(text, {"stated": stated(symbol, value, unit)}), value, across)
