"""Sentences that remember what they were made of, so that they can be said again in another language.

A template is one of ``str.format`` whose fields may end in a unit people use: ``{force:.5g kN}`` sets a force in N.
"""

import math
import re
import string
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, SupportsFloat

if TYPE_CHECKING:
    from .language import Language

SCALES = {
    "N": 1.0,
    "kN": 1e-3,
    "mm": 1e3,
    "N·m": 1.0,
    "N/mm": 1e-3,
    "1/mm": 1e-3,
    "kPa": 1e-3,
    "MPa": 1e-6,
    "GPa": 1e-9,
    "deg": 180 / math.pi,
    "kJ": 1e-3,
    "s": 1.0,
    "ms": 1e3,
    "N·m·s": 1.0,
    "J/mm²": 1e-6,
    "K": 1.0,
    "m": 1.0,
    "rad": 1.0,
    "N/m": 1.0,
    "1/m": 1.0,
}
"""Unit of a field → what a value in SI is multiplied by."""


ENGLISH = "en"
"""The language that everything is written in."""

_LANGUAGE: "ContextVar[Language | None]" = ContextVar("language", default=None)


class Text(str):
    """An English sentence that remembers what it was made of."""

    template: str
    values: Mapping[str, object] | None
    """What fills it; None where it is no template."""
    amount: int
    """Number that decides the plural form, where there is one."""
    context: str
    """Context of the template in the catalogue, where it is not a sentence."""

    def __new__(
        cls,
        template: str,
        values: Mapping[str, object] | None = None,
        many: str = "",
        count: int = 1,
        context: str = "",
    ) -> "Text":
        """Fill a template, or the one for many where ``count`` is not 1."""
        chosen = many if many and count != 1 else template
        text = super().__new__(cls, _SENTENCE.vformat(chosen, (), values) if values is not None else chosen)
        text.template, text.values, text.amount, text.context = template, values, count, context
        return text

    def __str__(self) -> str:
        """Return self, so that the template survives ``str()``."""
        return self


class _Sentence(string.Formatter):
    """``str.format`` whose numbers may carry a unit; ``{low:g mm…}{high:g mm}`` is a range that names it once.

    What is cut off a text, ``{name:.80}``, is marked. Of a list every member is set so.
    """

    def format_field(self, value: object, format_spec: str) -> str:
        if isinstance(value, list | tuple):
            return self.listed([self.format_field(each, format_spec) for each in value])
        number, _, unit = format_spec.partition(" ")
        if isinstance(value, str):
            shown = format(value, number)
            return shown if len(shown) >= len(value) else f"{shown}…"
        if not unit:
            return self.number(format(value, number)) if _is_number(value) else format(value, number)
        assert isinstance(value, SupportsFloat)
        shown = self.number(format(float(value) * SCALES[unit.removesuffix("…")], number))
        return f"{shown}…" if unit.endswith("…") else with_unit(shown, self.unit(unit))

    def listed(self, shown: list[str]) -> str:
        return ", ".join(shown)

    def number(self, shown: str) -> str:
        return shown

    def unit(self, name: str) -> str:
        return name


class _Translated(_Sentence):
    """The same in the language of the user."""

    def format_field(self, value: object, format_spec: str) -> str:
        return super().format_field(translate(value) if isinstance(value, Text) else value, format_spec)

    def listed(self, shown: list[str]) -> str:
        # a decimal comma does not separate as well
        return ("; " if any("," in each for each in shown) else ", ").join(shown)

    def number(self, shown: str) -> str:
        return localized(shown).replace("%", "\xa0%")

    def unit(self, name: str) -> str:
        return translate(name, "unit")


def with_unit(number: str, unit: str) -> str:
    """Set a number with its unit, none where it is pure; only the sign of a degree stands close to its number."""
    return number if unit in ("", "–") else f"{number}{unit if unit == '°' else f' {unit}'}"


_SENTENCE, _TRANSLATED = _Sentence(), _Translated()


def _is_number(value: object) -> bool:
    return isinstance(value, SupportsFloat) and not isinstance(value, bool)


@contextmanager
def speaking(language: "Language | None") -> Iterator[None]:
    """Speak a language for a while; None is English."""
    before = _LANGUAGE.set(language)
    try:
        yield
    finally:
        _LANGUAGE.reset(before)


def spoken() -> str:
    """Name of the language of the user."""
    own = _LANGUAGE.get()
    return own.name if own else ENGLISH


def translate(text: str, context: str = "") -> str:
    """Return an English text in the language of the user: a ``Text`` by its template, any other by the catalogue.

    What a user wrote is neither: only ``named`` is for it.

    Args:
        text: the text; one that is not known is returned as it is.
        context: what tells it from others of the same letters: ``unit``, ``value``; a ``Text`` may know its own.
    """
    language = _LANGUAGE.get()
    if language is None:
        return text
    if not isinstance(text, Text):
        return language.found(text, context) or text
    template = language.found(text.template, text.context or context, text.amount) or text.template
    return template if text.values is None else _TRANSLATED.vformat(template, (), text.values)


def named(name: str | None) -> str:
    """Return the name of a clutch, as given; only one that ships with the program has one in every language."""
    return translate(Text(name, context="name")) if name else ""


def localized(number: str) -> str:
    """Return a number, as Python writes it, as people write it in the language of the user."""
    own = _LANGUAGE.get()
    if own is None:
        return number
    mantissa, ten, exponent = number.translate(own.signs).partition("e")
    if not ten:
        return mantissa
    return f"{'' if mantissa == '1' else f'{mantissa}·'}10{str(int(exponent)).translate(RAISED)}"


RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def say(template: str, /, **values: object) -> str:
    """Fill a template.

    >>> say("the force is {force:.5g kN}, {times:g} times too much", force=2000.0, times=2)
    'the force is 2 kN, 2 times too much'
    """
    return Text(template, values)


def say_many(one: str, many: str, /, *, count: int, **values: object) -> str:
    """Fill the template for one or that for many; another language may have more forms.

    >>> say_many("{count} line", "{count} lines", count=3)
    '3 lines'
    """
    return Text(one, {"count": count, **values}, many, count)


def told(template: str, /, **values: object) -> str:
    """Say something at the edge, in the language of the user."""
    return translate(Text(template, values))


def filled(template: str, values: Mapping[str, object]) -> str:
    """Fill a template that stands in a table."""
    return Text(template, values)


def measured(value: float, unit: str, digits: int = 6) -> str:
    """Say a value in SI with the unit of ``SCALES``, none for a pure number.

    >>> measured(2000.0, "kN")
    '2 kN'
    """
    return Text(f"{{value:.{digits}g {unit}}}" if unit else f"{{value:.{digits}g}}", {"value": value})


def joined(parts: Iterable[object], sign: str = ", ") -> str:
    """Set texts one after the other, each of which may be translated."""
    listed = {f"part{number}": part for number, part in enumerate(parts)}
    return Text("{sign}".join(f"{{{name}}}" for name in listed), {**listed, "sign": sign})


def term(text: str, context: str = "") -> str:
    """Return a text of a table (a kind, a name) such that a sentence that names it is translated with it."""
    return text if isinstance(text, Text) else Text(text, context=context)


_HIDDEN = re.compile(
    "[\x00-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\U000e0000-\U000e007f]"
)
"""Characters that act on a terminal, turn the direction of writing, are not seen, or are none (undecodable bytes)."""


def printable(text: str, *, lines: bool = False) -> str:
    r"""Return a text that may hold anything (names, keys, arguments) such that it shows what it is, and only that.

    The escapes are those of JSON: a JSON text so treated says the same as before.

    Args:
        text: any text.
        lines: whether ends of lines are meant as such.

    >>> print(printable("a\x1b[31m \u202eb\n"))
    a\u001b[31m \u202eb\n
    """
    return _HIDDEN.sub(lambda sign: sign[0] if lines and sign[0] == "\n" else escaped(sign[0]), text)


def escaped(sign: str) -> str:
    """Return a character as JSON escapes it."""
    if sign in "\n\r\t":
        return repr(sign)[1:-1]
    words = sign.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{words[at : at + 4]}" for at in range(0, len(words), 4))
