"""Engineer's units (or SI) and significant figures for people; JSON and CSV stay in SI."""

import math
from contextlib import AbstractContextManager
from contextvars import ContextVar

from ..messages import latin, localized, printable, spoken, translate, with_unit, within
from ..units import ENGINEER, in_unit, per_si, typeset

CHOICES: dict[str, dict[str, str]] = {"engineer": ENGINEER, "si": {}}
"""Choice of units → SI unit → unit shown to people, if this is not the SI unit."""
_chosen = ContextVar("units", default=ENGINEER)
_DIGITS = 5
_ESTIMATED = dict.fromkeys(("J", "J/m^2", "W/m^2", "K", "K abs", "1/h", "kg", "kg*m^2"), 3)
"""SI unit of a quantity that rests on estimates (heat, temperature, mass) → its significant figures."""
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
"""Word that is a value in a spec or in JSON → words shown to people instead."""


def shown_in(name: str) -> AbstractContextManager[None]:
    """Context in which quantities are shown in the units ``name``, a key of ``CHOICES``."""
    return within(_chosen, CHOICES[name])


def shown_unit(unit: str) -> str:
    """Name of the unit that is shown to people in place of an SI unit.

    >>> shown_unit("N"), shown_unit("kg*m^2")
    ('kN', 'kg*m^2')
    """
    return _chosen.get().get(unit, unit)


def display_unit(unit: str) -> str:
    """Unit shown to people for an SI unit.

    >>> display_unit("N"), display_unit("kg*m^2")
    ('kN', 'kg·m²')
    """
    return "–" if unit == "1" else translate(typeset(shown_unit(unit)), "unit")


def converted(value: float, unit: str) -> float:
    """Return a value (SI) in the unit shown to people; a temperature is converted to the scale of that unit.

    >>> converted(2000.0, "N"), converted(300.15, "K abs")
    (2.0, 27.0)
    """
    shown = _chosen.get().get(unit)
    return in_unit(value, shown) if shown else value


def display(value: object, unit: str, digits: int = 0) -> str:
    """Return ``value`` (SI) in the unit shown to people, to ``digits`` figures; 0: as many as its unit requires.

    >>> display(2000.0, "N"), display(0.1, "m"), display(None, "1"), display(123456.7, "1")
    ('2', '100', '–', '123460')
    >>> display(8963.12, "J"), display(340.153, "K abs"), display(340.153, "K abs", 5), display(45565.4, "1", 3)
    ('8.96', '67', '67.003', '45600')
    >>> with shown_in("si"):
    ...     display(2000.0, "N"), display_unit("N"), display(293.15, "K abs")
    ('2000', 'N', '293')
    """
    if value is None:
        return "–"
    if isinstance(value, list):
        return (" … " if unit else "; ").join(display(item, unit, digits) for item in value)
    if isinstance(value, bool):
        return translate("yes" if value else "no", "value")
    if not isinstance(value, int | float):
        return printable(worded(str(value)))
    return significant(converted(value, unit), digits or _ESTIMATED.get(unit, _DIGITS))


def measured(value: object, unit: str) -> str:
    """Return a value (SI) with its unit, both as shown to people.

    >>> measured(2000.0, "N"), measured(0.5, "1")
    ('2 kN', '0.5')
    """
    return with_unit(display(value, unit, _DIGITS), display_unit(unit))


def headed(name: str, unit: str) -> str:
    """Return the name of a quantity, with its unit as shown to people unless it is a pure number.

    >>> headed("force", "N"), headed("gain", "1")
    ('force, kN', 'gain')
    """
    shown = display_unit(unit)
    return f"{name}, {shown}" if shown not in ("", "–") else name


def worded(text: str) -> str:
    """Return a text of a result in the language of the user, translated as a whole, else between semicolons."""
    if spoken() == "en":
        return _IN_ENGLISH.get(text) or (latin(text) if " " in text else text)
    # a single word may be a name, a sentence is no name
    for context in ("value", "", "comment", "name") if " " in text else ("value", "unit"):
        if (told := translate(text, context)) != text:
            return told
    return "; ".join(translate(part) for part in _IN_ENGLISH.get(text, text).split("; "))


def significant(value: float, digits: int = _DIGITS) -> str:
    """Significant figures, plain between 1e-4 and 1e7, with an exponent beyond.

    >>> significant(0.00012345678), significant(1e12), significant(100000.0)
    ('0.00012346', '1e+12', '100000')
    """
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else str(value)
    rounded = float(f"{value:.{digits}g}")
    if 1e-4 <= abs(rounded) < 1e7:
        return localized(f"{rounded:.10f}".rstrip("0").rstrip("."))
    return localized(f"{value:.{digits}g}")


def estimate(value: float, error: float, unit: str) -> str:
    """Return a value with its standard error in the engineer's unit: both to the second figure of the error.

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
