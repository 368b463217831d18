"""The units of fields, and those that specs are written in, known by heart: pint costs half the start-up.

Factors are decimal and exactly those pint finds (a test compares every row), so that it makes no difference which of
the two reads a unit. What is not here is pint's.
"""

from decimal import Decimal

from ..messages import say, term

EXAMPLES = {
    "N": ("a force", "2 kN"),
    "m": ("a length", "100 mm"),
    "N*m": ("a torque", "200 N*m"),
    "N/m": ("a stiffness", "20 N/mm"),
    "1/m": ("a slope of the gain", "18.75 1/m"),
    "rad": ("an angle", "30 deg"),
    "Pa": ("a pressure or stress", "400 MPa"),
    "m^3": ("a section modulus", "15 cm^3"),
    "rad/s": ("a speed of rotation", "1430 rpm"),
    "m/s": ("a speed", "0.3 m/s"),
    "s": ("a time", "10 ms"),
    "kg": ("a mass", "2 kg"),
    "kg*m^2": ("a moment of inertia", "8 kg*m^2"),
    "N*m/rad": ("a torsional stiffness", "8 kN*m/rad"),
    "kg/m^3": ("a density", "7850 kg/m^3"),
    "K abs": ("a temperature", "20 degC"),
    "J/kg/K": ("a specific heat", "480 J/kg/K"),
    "W/m/K": ("a thermal conductivity", "50 W/m/K"),
    "W/K": ("a cooling per kelvin", "2.5 W/K"),
    "J/m^2": ("a work per area", "1 J/mm^2"),
    "m^3/J": ("a wear per energy", "2e-5 mm^3/J"),
    "1": ("a plain number", "0.3"),
}
"""SI unit of a field → what it is, and how one may be written."""

SIGNS = str.maketrans({"·": "*", "⋅": "*", "×": "*", "²": "^2", "³": "^3"})
"""Signs that people write → those of the table."""

_FORCES = {"N": "1", "kN": "1e3", "MN": "1e6", "Н": "1", "кН": "1e3", "МН": "1e6"}
_LENGTHS = {"m": "1", "cm": "1e-2", "mm": "1e-3", "м": "1", "см": "1e-2", "мм": "1e-3"}
_PRESSURES = {"Pa": "1", "kPa": "1e3", "MPa": "1e6", "GPa": "1e9", "bar": "1e5"}
_PRESSURES |= {"Па": "1", "кПа": "1e3", "МПа": "1e6", "ГПа": "1e9", "N/mm^2": "1e6", "Н/мм^2": "1e6"}
_TIMES = {"s": "1", "ms": "1e-3", "с": "1", "мс": "1e-3"}
_RPM = "0.1047197551196597746154214461"
_DEGREE = "0.01745329251994329576923690768"


def _alike(first: str, second: str) -> bool:
    """Whether two units are of one alphabet."""
    return first.isascii() == second.isascii()


KNOWN: dict[str, dict[str, Decimal]] = {
    "N": {unit: Decimal(factor) for unit, factor in _FORCES.items()},
    "m": {unit: Decimal(factor) for unit, factor in _LENGTHS.items()},
    "N*m": {
        force + sign + length: Decimal(newtons) * Decimal(metres)
        for force, newtons in _FORCES.items()
        for length, metres in _LENGTHS.items()
        for sign in ("*", " ", "")
        if _alike(force, length)
    },
    "N/m": {
        f"{force}/{length}": Decimal(newtons) / Decimal(metres)
        for force, newtons in _FORCES.items()
        for length, metres in _LENGTHS.items()
        if _alike(force, length)
    },
    "1/m": {f"1/{unit}": 1 / Decimal(factor) for unit, factor in _LENGTHS.items()},
    "rad": {"rad": Decimal(1), "рад": Decimal(1)} | dict.fromkeys(("deg", "°", "degree", "град"), Decimal(_DEGREE)),
    "Pa": {unit: Decimal(factor) for unit, factor in _PRESSURES.items()},
    "rad/s": {"rad/s": Decimal(1), "рад/с": Decimal(1)} | dict.fromkeys(("rpm", "об/мин"), Decimal(_RPM)),
    "m/s": {"m/s": Decimal(1), "mm/s": Decimal("1e-3"), "м/с": Decimal(1), "мм/с": Decimal("1e-3")},
    "s": {unit: Decimal(factor) for unit, factor in _TIMES.items()},
    "kg": {"kg": Decimal(1), "g": Decimal("1e-3"), "кг": Decimal(1), "г": Decimal("1e-3")},
    "kg*m^2": {f"{mass}{sign}{length}^2": Decimal(1) for mass, length in (("kg", "m"), ("кг", "м")) for sign in "* "},
    "N*m/rad": {
        f"{force}{sign}m/rad": Decimal(_FORCES[force]) for force in ("N", "kN", "MN") for sign in ("*", " ", "")
    },
    "m^3": {f"{unit}^3": Decimal(factor) ** 3 for unit, factor in _LENGTHS.items()},
    "kg/m^3": {"kg/m^3": Decimal(1), "кг/м^3": Decimal(1), "g/cm^3": Decimal(1000)},
    "J/kg/K": {"J/kg/K": Decimal(1), "J/(kg*K)": Decimal(1), "Дж/(кг*К)": Decimal(1)},
    "W/m/K": {"W/m/K": Decimal(1), "W/(m*K)": Decimal(1), "Вт/(м*К)": Decimal(1)},
    "W/K": {"W/K": Decimal(1), "Вт/К": Decimal(1)},
    "J/m^2": {"J/m^2": Decimal(1), "kJ/m^2": Decimal(1000)}
    | dict.fromkeys(("J/mm^2", "Дж/мм^2"), Decimal("1e6"))
    | dict.fromkeys(("J/cm^2", "Дж/см^2"), Decimal("1e4")),
    "m^3/J": {"m^3/J": Decimal(1), "mm^3/J": Decimal("1e-9"), "мм^3/Дж": Decimal("1e-9")},
}
"""SI unit of a field → unit as written → how many SI units it is."""

FREEZING = Decimal("273.15")
"""0 °C in kelvin."""

SCALES: dict[str, dict[str, Decimal]] = {
    "K abs": {"K": Decimal(0), "К": Decimal(0)} | dict.fromkeys(("degC", "°C", "°С"), FREEZING),
}
"""Unit of a field that counts from a zero of its own → scale as written → its zero, in SI."""


def allowed(unit: str) -> str:
    """Say what may stand in a field of the SI unit ``unit``."""
    kind, example = EXAMPLES[unit]
    if unit == "1":
        return say("give {kind} such as {example}", kind=term(kind), example=example)
    return say(
        'give {kind}: a number in SI ({unit}) or a string with a unit such as "{example}"',
        kind=term(kind),
        unit=unit,
        example=example,
    )
