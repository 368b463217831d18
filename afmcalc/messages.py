"""What people are told: English sentences that keep their template and values, and the languages they are told in.

A template is one of ``str.format`` whose fields may end in a unit people use: ``{force:.5g kN}`` sets a force given in
N. So a template holds no arithmetic and a value stays SI. Inside everything is English; a sentence is a ``Text``, and
the edge, which alone knows to whom it speaks, has it in the language of the user: ``translate``. The English template
is the key of a message, as in gettext: ``say("{path}: is no table", path=path)``, always a literal so that it can be
collected. Translations stand in ``locale/NAME.po``, and compiled in ``locale/NAME.mo``, which is what is read.

Below them: characters that must not reach a terminal, letters that a stream lacks, words that look alike.
"""

import codecs
import os
import re
import string
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import cache
from typing import TYPE_CHECKING, Any, SupportsFloat

if TYPE_CHECKING:
    from gettext import GNUTranslations


class Language(string.Formatter):
    """Fills templates in one language: its texts, and numbers and units as its readers write them.

    ``{low:g mm…}{high:g mm}`` is a range that names its unit once. A text that is cut off, ``{name:.80}``, is marked.
    Of a list every member is set by the format of the field.
    """

    def __init__(
        self, name: str, catalogue: "GNUTranslations | None" = None, decimal: str = ".", group: str = ","
    ) -> None:
        """Take the texts of ``catalogue``, those of English where there is none, and the signs of numbers."""
        self.name = name
        self.catalogue = catalogue
        self.signs = str.maketrans({".": decimal, ",": group})

    def translated(self, text: str, context: str = "") -> str:
        """Return a text in this language: a ``Text`` by its template, any other, if it is known, by its letters."""
        if self.catalogue is None:
            return text
        if not isinstance(text, Text):
            return self._known(text, context)
        if text.plural:
            template = self.catalogue.ngettext(text.template, text.plural, text.amount)
        else:
            template = self._known(text.template, text.context or context)
        return template if text.values is None else self.vformat(template, (), text.values)

    def _known(self, text: str, context: str) -> str:
        assert self.catalogue is not None
        if context or not text:  # of nothing gettext gives the head of the catalogue
            return self.catalogue.pgettext(context, text)
        sentence = self.catalogue.gettext(text)
        return self.catalogue.pgettext("value", text) if sentence == text else sentence

    def format_field(self, value: object, format_spec: str) -> str:
        """Set one value of a sentence."""
        if isinstance(value, list | tuple):
            members = [self.format_field(member, format_spec) for member in value]
            # a decimal comma does not separate as well
            return ("; " if self.catalogue and any("," in member for member in members) else ", ").join(members)
        if isinstance(value, Exception):  # of an own one the sentence, of which another language has its own
            value = value.args[0] if value.args and isinstance(value.args[0], Text) else str(value)
        number_format, _, unit = format_spec.partition(" ")
        if isinstance(value, str):
            text = self.translated(value) if isinstance(value, Text) else value
            shown = format(text, number_format)
            return shown if len(shown) >= len(text) else f"{shown}…"
        if not unit:
            is_number = isinstance(value, SupportsFloat) and not isinstance(value, bool)
            counts = is_number and (number_format or isinstance(value, float))  # a port or a line is no amount
            return self.number(format(value, number_format)) if counts else format(value, number_format)
        assert isinstance(value, SupportsFloat)
        from .units import in_unit

        shown = self.number(format(in_unit(float(value), unit.removesuffix("…")), number_format))
        return f"{shown}…" if unit.endswith("…") else with_unit(shown, self.translated(unit, "unit"))

    def number(self, shown: str) -> str:
        """Set a number, given as Python writes it, as people write it."""
        if self.catalogue is None:
            return shown
        shown = _LONG.sub(lambda digits: f"{int(digits[0]):,}", shown.replace(",", "").replace("inf", "∞"))
        mantissa, ten, exponent = shown.translate(self.signs).replace("%", "\xa0%").partition("e")
        mantissa = mantissa.replace("-", "−")
        if not ten:
            return mantissa
        return f"{'' if mantissa == '1' else f'{mantissa}·'}10{str(int(exponent)).translate(RAISED)}"


_LONG = re.compile(r"(?<![\d.])\d{5,}")
"""Digits before a decimal point that are set in groups."""

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_LOWERED = {raised: digit for digit, raised in RAISED.items()}

ENGLISH = Language("en")
"""The language that everything is written in."""

FOLDER = os.path.join(os.path.dirname(__file__), "locale")
WRITTEN = {"ru": (",", "\xa0")}
"""Language of those that ship → its decimal sign, and what sets groups of digits apart."""


@cache
def known() -> list[str]:
    """Names of the languages that there is a catalogue of."""
    return sorted(name.removesuffix(".mo") for name in os.listdir(FOLDER) if name.endswith(".mo"))


@cache
def language(name: str) -> Language:
    """Return a language by its name."""
    from gettext import GNUTranslations

    with open(os.path.join(FOLDER, f"{name}.mo"), "rb") as file:
        return Language(name, GNUTranslations(file), *WRITTEN.get(name, (".", ",")))


class Text(str):
    """An English sentence that remembers what it was made of."""

    template: str
    values: Mapping[str, object] | None
    """Values that fill it; None where it is no template."""
    plural: str
    """Template for an ``amount`` other than 1, where there is one."""
    amount: int
    context: str
    """Context of the template in the catalogue, where it is not a sentence."""

    def __new__(
        cls,
        template: str,
        values: Mapping[str, object] | None = None,
        plural: str = "",
        amount: int = 1,
        context: str = "",
    ) -> "Text":
        """Fill a template."""
        english = plural if plural and amount != 1 else template
        text = super().__new__(cls, english if values is None else ENGLISH.vformat(english, (), values))
        text.template, text.values, text.plural, text.amount, text.context = template, values, plural, amount, context
        return text

    def __str__(self) -> str:
        """Return self, so that the template survives ``str()``."""
        return self


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


def term(text: str, context: str = "") -> str:
    """Return a text of a table (a kind, a name) such that a sentence that names it is translated with it."""
    return text if isinstance(text, Text) else Text(text, context=context)


def joined(parts: Iterable[object], sign: str = ", ") -> str:
    """Set texts one after the other, each of which may be translated."""
    values = {f"part{number}": part for number, part in enumerate(parts)}
    return Text("{sign}".join(f"{{{name}}}" for name in values), {**values, "sign": sign})


def measured(value: float, unit: str, digits: int = 6) -> str:
    """Say a value in SI in the unit of that name, which is "1" of a pure number.

    >>> measured(2000.0, "kN"), measured(0.5, "1")
    ('2 kN', '0.5')
    """
    from .units import typeset

    return Text(f"{{value:.{digits}g {typeset(unit)}}}", {"value": value})


def percent(share: float) -> str:
    """Say a share of a limit, never as 100 % what is below or beyond it.

    >>> percent(0.99952), percent(0.5), percent(1.00001)
    ('99.95%', '50.0%', '100.001%')
    """
    digits = next((digits for digits in range(1, 8) if float(f"{share:.{digits + 2}f}") != 1), 1)
    return Text(f"{{share:.{digits}%}}", {"share": share})


def with_unit(number: str, unit: str) -> str:
    """Set a number with its unit, none where it is pure; only the sign of a degree stands close to its number."""
    return number if unit in ("", "–") else f"{number}{unit if unit == '°' else f' {unit}'}"


_LANGUAGE: ContextVar[Language | None] = ContextVar("language", default=None)


def _current() -> Language:
    """Return the language spoken; where the program does not say it (from Python), that of AFMCALC_LANG."""
    if speaks := _LANGUAGE.get():
        return speaks
    name = os.environ.get("AFMCALC_LANG")
    with suppress(Exception):  # a file that cannot be read is told of where the language is chosen
        return language(name) if name and name in known() else ENGLISH
    return ENGLISH


@contextmanager
def speaking(language: Language) -> Iterator[None]:
    """Speak a language in the block."""
    before = _LANGUAGE.set(language)
    try:
        yield
    finally:
        _LANGUAGE.reset(before)


def spoken() -> str:
    """Name of the language of the user."""
    return _current().name


def translate(text: str, context: str = "") -> str:
    """Return an English text in the language of the user: a ``Text`` by its template, any other by the catalogue.

    What a user wrote is neither: only ``named`` is for it.

    Args:
        text: the text; one that is not known is returned as it is.
        context: what tells it from others of the same letters: ``unit``, ``value``; a ``Text`` may know its own.
    """
    return _current().translated(text, context)


def told(template: str, /, **values: object) -> str:
    """Say something at the edge, in the language of the user."""
    return translate(Text(template, values))


def named(name: str | None) -> str:
    """Return the name of a clutch, as given; only one that ships with the program has one in every language."""
    return translate(name, "name") if name else ""


def localized(number: str) -> str:
    """Return a number, as Python writes it, as people write it in the language of the user."""
    return _current().number(number)


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

    def escaped(hidden: re.Match[str]) -> str:
        import json

        return hidden[0] if lines and hidden[0] == "\n" else json.dumps(hidden[0])[1:-1]

    return _HIDDEN.sub(escaped, text)


SPELLED = "afmcalc.spelled"
"""Error handler of streams: letters that the encoding lacks are spelled, ``T_н`` becomes T_n."""

_ALPHABETS = "абвгдеёжзийклмнопрстуфхцчшщъыьэюя" + "αβγδεζηθικλμνξοπρσςτυφχψωϑϕ"
_IN_ASCII = (
    "a b v g d e e zh z i y k l m n o p r s t u f kh ts ch sh shch ' y ' e yu ya "
    "alpha beta gamma delta eps zeta eta theta iota kappa lambda mu nu xi o pi rho sigma s tau upsilon phi chi psi "
    "omega theta phi"
)
_SIGNS = {
    "–": "-", "—": "-", "−": "-", "…": "...", "·": "*", "•": "*", "×": "x", "≤": "<=", "≥": ">=", "≈": "~", "≠": "!=",
    "±": "+-", "°": "deg", "√": "sqrt", "∞": "inf", "→": "->", "∂": "d", "∝": "~", "₊": "+",
    "₋": "-", "′": "'", "‘": "'", "’": "'", "“": '"', "”": '"', "«": '"', "»": '"', "\u00a0": " ", "\u2009": " ",
}  # fmt: skip
_LETTERS = dict(zip(_ALPHABETS, _IN_ASCII.split(), strict=True))
_SPELLED = _LETTERS | {letter.upper(): spelled.capitalize() for letter, spelled in _LETTERS.items()} | _SIGNS
# a difference, not a letter: ΔT is dT, as --sweep calls it
_SPELLED["Δ"] = "d"
_POWER = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_OF_A_SPRING = re.compile(r"(?<=[_,])п(?![^\W\d_])")
"""The index of a spring: F_п is F_sp, for F_p is the release force."""


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    lacking = "".join(
        "sp" if _OF_A_SPRING.match(error.object, at) else error.object[at] for at in range(error.start, error.end)
    )
    lacking = _POWER.sub(lambda power: f"^{power[0].translate(_LOWERED)}", lacking)
    return "".join(
        sign if sign.isascii() else _SPELLED.get(sign) or sign.encode("ascii", "backslashreplace").decode()
        for sign in lacking
    ), error.end


codecs.register_error(SPELLED, _spelled)


def fitting(text: str, encoding: str) -> str:
    """Return a text as a stream of an encoding shows it.

    >>> fitting("ΔT = 10⁻³ T_н, °C", "ascii"), fitting("T_н", "koi8-r"), fitting("漢", "ascii")
    ('dT = 10^-3 T_n, degC', 'T_н', '\\\\u6f22')
    >>> fitting("F_п1, K_т,п, F_p, T_пр", "ascii")
    'F_sp1, K_t,sp, F_p, T_pr'
    """
    return text.encode(encoding, SPELLED).decode(encoding)


def is_unicode(stream: Any) -> bool:
    """True if a stream takes any text."""
    return (getattr(stream, "encoding", "") or "").lower().replace("-", "").startswith("utf")


_LONGEST_WORD = 60
"""Letters of a word that is worth comparing."""

_LATIN = str.maketrans(
    dict(zip("АВЕКМНОРСТУХавекмнорстухпдш", "ABEKMHOPCTYXabekmnopctyxpds", strict=True))
    | {"α": "alpha", "β": "beta", "ν": "nu", "τ": "tau", "Δ": "d"}
)
"""Letters that are taken for Latin ones, or stand for them in the symbols of the papers → these."""


def plain(name: str) -> str:
    """Return a name in Latin letters, however its letters were typed.

    >>> plain("К_т"), plain("ΔT")
    ('K_t', 'dT')
    """
    return name.translate(_LATIN)


def in_latin(word: str) -> str:
    """Return ``"; did you mean 'x'?"`` for a word that looks as if it were Latin, or nothing.

    >>> in_latin("densitу")
    "; did you mean 'density' (all Latin)?"
    """
    latin = plain(word)
    return say("; did you mean {latin!r} (all Latin)?", latin=latin) if latin.isascii() and latin != word else ""


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ``"; did you mean 'x'?"`` for the nearest known word, or nothing when none is near.

    >>> did_you_mean("frction", ["friction", "drive"])
    "; did you mean 'friction'?"
    """
    known = list(known)
    if word in known or len(word) > _LONGEST_WORD:
        return ""
    if plain(word) in known:
        return in_latin(word)
    from difflib import get_close_matches

    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(plain(word).casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""
