"""Engineer's units (or SI) and significant figures for people; JSON and CSV stay in SI."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from ..messages import latin, localized, printable, spoken, translate, with_unit
from ..units import ENGINEER, in_unit, per_si, typeset

CHOICES: dict[str, dict[str, str]] = {"engineer": ENGINEER, "si": {}}
"""Which units people choose → SI unit to the one shown, where it is another."""
_chosen = ContextVar("units", default=ENGINEER)


@contextmanager
def shown_in(name: str) -> Iterator[None]:
    """Show quantities in the units of that name, one of ``CHOICES``, until the end of the block."""
    before = _chosen.set(CHOICES[name])
    try:
        yield
    finally:
        _chosen.reset(before)


def display_unit(unit: str) -> str:
    """Unit shown to people for an SI unit.

    >>> display_unit("N"), display_unit("kg*m^2")
    ('kN', 'kg·m²')
    """
    return "–" if unit == "1" else translate(typeset(_chosen.get().get(unit, unit)), "unit")


def converted(value: float, unit: str) -> float:
    """Return a value (SI) in the unit shown to people, a temperature on its scale.

    >>> converted(2000.0, "N"), converted(300.15, "K abs")
    (2.0, 27.0)
    """
    shown = _chosen.get().get(unit)
    return in_unit(value, shown) if shown else value


def display(value: object, unit: str) -> str:
    """Return ``value`` (SI) in the unit shown to people, to 5 significant figures.

    >>> display(2000.0, "N"), display(0.1, "m"), display(None, "1"), display(123456.7, "1")
    ('2', '100', '–', '123460')
    >>> with shown_in("si"):
    ...     display(2000.0, "N"), display_unit("N"), display(293.15, "K abs")
    ('2000', 'N', '293.15')
    """
    if value is None:
        return "–"
    if isinstance(value, list):
        return (" … " if unit else "; ").join(display(item, unit) for item in value)
    if isinstance(value, bool):
        return translate("yes" if value else "no", "value")
    if not isinstance(value, int | float):
        return printable(worded(str(value)))
    return significant(converted(value, unit))


def measured(value: object, unit: str) -> str:
    """Return a value (SI) with its unit, both as shown to people.

    >>> measured(2000.0, "N"), measured(0.5, "1")
    ('2 kN', '0.5')
    """
    return with_unit(display(value, unit), display_unit(unit))


def headed(name: str, unit: str) -> str:
    """Return the name of a quantity with its unit as shown to people, where it has one.

    >>> headed("force", "N"), headed("gain", "1")
    ('force, kN', 'gain')
    """
    shown = display_unit(unit)
    return f"{name}, {shown}" if shown not in ("", "–") else name


def worded(text: str) -> str:
    """Return a text of a result in the language of the user; one made of several may be known in its parts only."""
    if spoken() == "en":
        return _IN_ENGLISH.get(text) or (latin(text) if " " in text else text)
    # one word may be a name; a sentence is none
    for context in ("value", "", "comment", "name") if " " in text else ("value", "unit"):
        if (told := translate(text, context)) != text:
            return told
    return "; ".join(translate(part) for part in _IN_ENGLISH.get(text, text).split("; "))


_IN_ENGLISH = {
    "min-friction": "smallest friction, f_min",
    "mean-friction": "mean friction, f_cp",
    "mean-stress": "mean stress",
    "hertz-ball-on-flat": "Hertz, ball on a flat",
    "hertz-ball-on-curved-wall": "Hertz, ball on a curved wall",
    "uniform-wear": "uniform wear",
    "uniform-pressure": "uniform pressure",
    "as-made": "as made for the nominal clutch",
    "each-adjusted": "each clutch adjusted",
    "simulate": "simulation of the event",
}
"""Values that are words of the spec or of JSON → what people are told."""


def significant(value: float) -> str:
    """Five significant figures, plain between 1e-4 and 1e7, with an exponent beyond.

    >>> significant(0.00012345678), significant(1e12), significant(100000.0)
    ('0.00012346', '1e+12', '100000')
    """
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else str(value)
    rounded = float(f"{value:.5g}")
    if 1e-4 <= abs(rounded) < 1e7:
        return localized(f"{rounded:.10f}".rstrip("0").rstrip("."))
    return localized(f"{value:.5g}")


def estimate(value: float, error: float, unit: str) -> str:
    """Return a value with its standard error in the engineer's unit: the error to two figures, the value to its last.

    >>> estimate(258.1534, 0.08938, "N*m"), estimate(9.3523e14, 1.3563e12, "1"), estimate(0.0, 5e-6, "1")
    ('258.153 ± 0.089', '(9.352 ± 0.014)e+14', '0 ± 5e-06')
    >>> estimate(123456.0, 2341.0, "1"), estimate(2.5, 0.0, "1")
    ('123500 ± 2300', '2.5')
    """
    shown = _chosen.get().get(unit)
    value, error = converted(value, unit), error * (per_si(shown) if shown else 1.0)
    if not error > 0 or not math.isfinite(error):
        return significant(value)
    if value == 0:
        return f"0 ± {significant(float(f'{error:.2g}'))}"
    largest = math.floor(math.log10(max(abs(value), error)))
    power = largest if not -4 <= largest < 7 else 0
    value, error = value / 10.0**power, float(f"{error:.2g}") / 10.0**power
    places = 1 - math.floor(math.log10(error) + 1e-9)
    figures = " ± ".join(f"{round(figure, places):.{max(places, 0)}f}" for figure in (value, error))
    return localized(f"({figures})e{power:+03d}" if power else figures)
