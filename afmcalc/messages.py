"""Sentences, numbers and symbols in the user's language; gettext translates a sentence when it is made.

English texts are the keys of the translations: ``say("{path}: is no table", path=path)``, always a literal so that
tests can collect it; a text in a table built at import is marked ``deferred`` and translated where it is used. A
field may end in a unit: ``{force:.5g kN}`` shows a force given in N, so values stay SI. Translations stand in
``locale/NAME.po``, compiled to ``locale/NAME.mo``.
"""

import os
import re
import string
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import cache, lru_cache, partial
from gettext import GNUTranslations, NullTranslations
from typing import Any, SupportsFloat, TypeVar, cast

from .units import in_unit, table, typeset

T = TypeVar("T")
FOLDER = os.path.join(os.path.dirname(__file__), "locale")
WRITTEN = {"ru": (",", "\xa0")}
"""Translated language → its decimal sign and its separator of digit groups."""


class Language(string.Formatter):
    """Translations into one language, and a formatter that writes numbers and units by its conventions.

    ``{low:g mm…}{high:g mm}`` is a range that names its unit once. A text cut by ``{name:.80}`` ends in an ellipsis.
    The format of a field applies to every member of a list.
    """

    def __init__(self, name: str, catalogue: NullTranslations) -> None:
        """Take translations from ``catalogue``."""
        self.name, self.catalogue = name, catalogue
        decimal, group = WRITTEN.get(name, (".", ","))
        self._signs = str.maketrans({".": decimal, ",": group})

    def format_field(self, value: object, format_spec: str) -> str:
        """Text of the value of one field."""
        if isinstance(value, list | tuple):
            members = [self.format_field(member, format_spec) for member in value]
            # list members with decimal commas are separated by semicolons
            return ("; " if any(self is not ENGLISH and "," in each for each in members) else ", ").join(members)
        number_format, _, unit = format_spec.partition(" ")
        if isinstance(value, str | Exception):
            text = str(value)
            shown = format(text, number_format)
            return shown if len(shown) >= len(text) else f"{shown}…"
        if not unit:
            is_number = hasattr(value, "__float__") and not isinstance(value, bool)
            counts = is_number and (number_format or isinstance(value, float))  # a bare integer is a port or a line
            return self.number(format(value, number_format)) if counts else format(value, number_format)
        amount = float(cast(SupportsFloat, value))
        shown = self.number(format(in_unit(amount, unit.removesuffix("…")), number_format))
        return f"{shown}…" if unit.endswith("…") else with_unit(shown, self.catalogue.pgettext("unit", unit))

    def number(self, shown: str) -> str:
        """Number written by Python ('0.5') in the notation of this language ('0,5')."""
        if self is ENGLISH:
            return shown
        # five or more digits before a decimal point are written in groups of three
        plain = shown.replace(",", "").replace("inf", "∞")
        shown = re.sub(r"(?<![\d.])\d{5,}", lambda digits: f"{int(digits[0]):,}", plain)
        mantissa, ten, exponent = shown.translate(self._signs).replace("%", "\xa0%").partition("e")
        mantissa = mantissa.replace("-", "−")
        if not ten:
            return mantissa
        return f"{'' if mantissa == '1' else f'{mantissa}·'}10{str(int(exponent)).translate(RAISED)}"


RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

ENGLISH = Language("en", NullTranslations())
"""Language of the texts in the source code."""
LANGUAGES = (ENGLISH.name, *WRITTEN)
"""Names of the languages that ship."""


@cache
def language(name: str) -> Language:
    """Language by its name; its catalogue is read once."""
    if name == ENGLISH.name:
        return ENGLISH
    with open(os.path.join(FOLDER, f"{name}.mo"), "rb") as file:
        return Language(name, GNUTranslations(file))


_LANGUAGE: ContextVar[Language | None] = ContextVar("language", default=None)


def _current() -> Language:
    """Language set by ``speaking``; otherwise (from Python) the language of AFMCALC_LANG, else English."""
    if chosen := _LANGUAGE.get():
        return chosen
    name = os.environ.get("AFMCALC_LANG", "")
    with suppress(Exception):  # an unreadable file is reported where the language is chosen
        return language(name) if name in LANGUAGES else ENGLISH
    return ENGLISH


@contextmanager
def within(variable: ContextVar[T], value: T) -> Iterator[None]:
    """Set a variable inside the ``with`` block."""
    before = variable.set(value)
    try:
        yield
    finally:
        variable.reset(before)


speaking = partial(within, _LANGUAGE)
"""Context in which a language is used."""


def spoken() -> str:
    """Name of the language of the user."""
    return _current().name


def say(template: str, /, **values: object) -> str:
    """Sentence in the user's language: ``template``, a literal, translated and filled with ``values``.

    >>> say("the force is {force:.5g kN}, {times:g} times too much", force=2000.0, times=2)
    'the force is 2 kN, 2 times too much'
    """
    return filled(template, values)


def filled(template: str, values: Mapping[str, object]) -> str:
    """Sentence as from ``say``, but from a template that is no literal (one in a table)."""
    return _current().vformat(translate(template), (), values)


def translate(text: str, context: str = "") -> str:
    """Text of the program, with its symbols, in the user's language; English if the catalogue lacks the text.

    ``context``: context in the catalogue, such as ``unit`` or ``value``. A name given by the user is for ``named``.
    """
    if _current() is ENGLISH:
        return latin(text) if context in ("", "comment", "symbol") else text
    catalogue = _current().catalogue
    if context or not text:  # gettext translates '' to the header of the catalogue
        return catalogue.pgettext(context, text)
    sentence = catalogue.gettext(text)
    return catalogue.pgettext("value", text) if sentence == text else sentence


def deferred(text: str) -> str:
    """Text unchanged, marked for the catalogue; it is translated where it is used."""
    return text


def named(name: str | None) -> str:
    """Name of a clutch as given, empty for None; names of the built-in examples are translated."""
    return translate(name, "name") if name else ""


def localized(number: str) -> str:
    """Number written by Python ('0.5') in the notation of the user's language ('0,5')."""
    return _current().number(number)


def measured(value: float, unit: str, digits: int = 6) -> str:
    """SI value converted to ``unit`` and followed by the unit; the unit "1" of a pure number is not shown.

    >>> measured(2000.0, "kN"), measured(0.5, "1")
    ('2 kN', '0.5')
    """
    return _current().format_field(value, f".{digits}g {typeset(unit)}")


def percent(share: float) -> str:
    """Share of a limit in percent, with enough digits that only a share of exactly 1 is shown as 100 %.

    >>> percent(0.99952), percent(0.5), percent(1.00001)
    ('99.95%', '50.0%', '100.001%')
    """
    digits = next((digits for digits in range(1, 8) if float(f"{share:.{digits + 2}f}") != 1), 1)
    return localized(f"{share:.{digits}%}")


def with_unit(number: str, unit: str) -> str:
    """Number followed by its unit, or alone if it is a pure number; only ° follows without a space."""
    return number if unit in ("", "–") else f"{number}{unit if unit == '°' else f' {unit}'}"


_LATIN = table("""\
н = n; т = T; п = sp; ш = ball; ц = c; д = dyn; в = sh; р = s; cp = mean; ср = pub; муф = c; маш = m; дв = mot;
пуск = st; тр = fr; зад = req; ном = nom""")
"""Index of a symbol in the papers → Latin abbreviation of its English meaning."""
_LATIN_OF = table("F_п = cl; T_п = pot; K_п = n; m_п = st; T_муф = exp; T_маш = mach; σ_т τ_т = y")
"""Symbol whose index has another meaning than in ``_LATIN`` → its Latin index."""
_INDEXED = r"(?<![^\W_])[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*"
_SYMBOL = rf"\b\w+ wanted|(?<=\)_)opt\b| or (?=κ)|(?:{_INDEXED}|(?<![^\W_])(?:(?:arc)?tanh?|cot))(?![^\W_])"
"""Patterns of symbols; compiled at their first use, which takes milliseconds."""


@lru_cache(4096)  # most texts are templates in tables, which are used again and again
def latin(text: str) -> str:
    """Text with the indices of symbols in Latin letters; a quotation in «» stays as printed.

    >>> latin("T_н.маш, K_т,act"), latin("F_п"), latin("F_п2"), latin("f_1cp"), latin("T'_п")
    ('T_n,m, K_T,act', 'F_cl', 'F_sp2', 'f_1mean', "T'_pot")
    """
    return _unquoted(_INDEXED, _latin_symbol, text) if "_" in text else text


def _latin_symbol(symbol: re.Match[str]) -> str:
    letter, _, index = symbol[0].partition("_")
    first, *others = re.split("[.,]", index)
    own = _LATIN_OF.get(f"{letter.rstrip(chr(39))}_{first}")
    index = ",".join((own or first, *others))
    words = re.sub(r"[а-яё]+|(?<![^\W\d_])cp(?![^\W\d_])", lambda word: _LATIN.get(word[0], word[0]), index)
    return f"{letter}_{words}"


def native(text: str) -> str:
    """Text with its symbols in the letters of the user's language: ``F_cl`` or ``F_п``, ``tan α`` or ``tg α``.

    A quotation in «» stays as printed.
    """
    if _current() is ENGLISH:
        return latin(text)
    return _unquoted(_SYMBOL, _native, text)


def _unquoted(pattern: str, replace: Callable[[re.Match[str]], str], text: str) -> str:
    parts = re.split("(«[^»]*»)", text)
    return "".join(part if part[:1] == "«" else re.sub(pattern, replace, part) for part in parts)


def _native(symbol: re.Match[str]) -> str:
    whole = translate(symbol[0], "symbol")
    return whole if whole != symbol[0] else re.sub(r"[^\W\d_]{2,}", lambda word: translate(word[0], "symbol"), whole)


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Hint ``"; did you mean 'x'?"`` with the nearest known word; empty if no known word is near.

    >>> did_you_mean("frction", ["friction", "drive"])
    "; did you mean 'friction'?"
    """
    known = list(known)
    if word in known or len(word) > 60:
        return ""
    from difflib import get_close_matches

    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(word.casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""


_HIDDEN = (
    "[\x00-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\U000e0000-\U000e007f]"
)
"""Control, invisible and direction-changing characters, and surrogates (undecodable bytes)."""


def printable(text: str, *, lines: bool = False) -> str:
    r"""Text from outside (names, keys, arguments) with its hidden characters escaped as in JSON.

    ``lines``: keep line breaks.

    >>> print(printable("a\x1b[31m \u202eb\n"))
    a\u001b[31m \u202eb\n
    """

    def escaped(hidden: re.Match[str]) -> str:
        import json

        return hidden[0] if lines and hidden[0] == "\n" else json.dumps(hidden[0])[1:-1]

    return re.sub(_HIDDEN, escaped, text)


def is_unicode(stream: Any) -> bool:
    """True if the encoding of a stream has all characters."""
    return (getattr(stream, "encoding", "") or "").lower().replace("-", "").startswith("utf")
