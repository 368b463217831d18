"""Sentences, numbers and symbols in the language of the user; sentences are translated by gettext when they are made.

English texts are the keys: ``say("{path}: is no table", path=path)``, always a literal so that it can be collected;
one of a table made on import is marked ``deferred`` and translated where it is used. A field may end in a unit:
``{force:.5g kN}`` shows a force given in N, so a value stays SI. Translations stand in ``locale/NAME.po``, compiled in
``locale/NAME.mo``.
"""

import os
import re
import string
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import cache
from gettext import GNUTranslations, NullTranslations
from typing import Any, SupportsFloat, cast

from .units import in_unit, table, typeset

FOLDER = os.path.join(os.path.dirname(__file__), "locale")
WRITTEN = {"ru": (",", "\xa0")}
"""Language of those that ship → its decimal sign, and what sets groups of digits apart."""


class Language(string.Formatter):
    """Translations into one language, and a formatter that writes numbers and units as its readers do.

    ``{low:g mm…}{high:g mm}`` is a range that names its unit once. A text that is cut off, ``{name:.80}``, is marked.
    Of a list every member is set by the format of the field.
    """

    def __init__(self, name: str, catalogue: NullTranslations) -> None:
        """Take translations from ``catalogue``."""
        self.name, self.catalogue = name, catalogue
        decimal, group = WRITTEN.get(name, (".", ","))
        self._signs = str.maketrans({".": decimal, ",": group})

    def format_field(self, value: object, format_spec: str) -> str:
        """Set one value of a sentence."""
        if isinstance(value, list | tuple):
            members = [self.format_field(member, format_spec) for member in value]
            # a decimal comma does not separate as well
            return ("; " if any(self is not ENGLISH and "," in each for each in members) else ", ").join(members)
        number_format, _, unit = format_spec.partition(" ")
        if isinstance(value, str | Exception):
            text = str(value)
            shown = format(text, number_format)
            return shown if len(shown) >= len(text) else f"{shown}…"
        if not unit:
            is_number = hasattr(value, "__float__") and not isinstance(value, bool)
            counts = is_number and (number_format or isinstance(value, float))  # a port or a line is no amount
            return self.number(format(value, number_format)) if counts else format(value, number_format)
        amount = float(cast(SupportsFloat, value))
        shown = self.number(format(in_unit(amount, unit.removesuffix("…")), number_format))
        return f"{shown}…" if unit.endswith("…") else with_unit(shown, self.catalogue.pgettext("unit", unit))

    def number(self, shown: str) -> str:
        """Set a number, given as Python writes it, as people write it."""
        if self is ENGLISH:
            return shown
        shown = _LONG.sub(lambda digits: f"{int(digits[0]):,}", shown.replace(",", "").replace("inf", "∞"))
        mantissa, ten, exponent = shown.translate(self._signs).replace("%", "\xa0%").partition("e")
        mantissa = mantissa.replace("-", "−")
        if not ten:
            return mantissa
        return f"{'' if mantissa == '1' else f'{mantissa}·'}10{str(int(exponent)).translate(RAISED)}"


_LONG = re.compile(r"(?<![\d.])\d{5,}")
"""Digits before a decimal point that are set in groups."""
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

ENGLISH = Language("en", NullTranslations())
"""The language that everything is written in."""
LANGUAGES = (ENGLISH.name, *WRITTEN)
"""Names of the languages that ship."""


@cache
def language(name: str) -> Language:
    """Language of a name."""
    if name == ENGLISH.name:
        return ENGLISH
    with open(os.path.join(FOLDER, f"{name}.mo"), "rb") as file:
        return Language(name, GNUTranslations(file))


_LANGUAGE: ContextVar[Language | None] = ContextVar("language", default=None)


def _current() -> Language:
    """Language of the user; where the program does not set it (from Python), that of AFMCALC_LANG."""
    if chosen := _LANGUAGE.get():
        return chosen
    name = os.environ.get("AFMCALC_LANG", "")
    with suppress(Exception):  # a file that cannot be read is reported where the language is chosen
        return language(name) if name in LANGUAGES else ENGLISH
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


def say(template: str, /, **values: object) -> str:
    """Sentence of a template in the language of the user.

    >>> say("the force is {force:.5g kN}, {times:g} times too much", force=2000.0, times=2)
    'the force is 2 kN, 2 times too much'
    """
    return filled(template, values)


def filled(template: str, values: Mapping[str, object]) -> str:
    """Sentence of a template of a table in the language of the user."""
    return _current().vformat(translate(template), (), values)


def say_many(one: str, many: str, /, *, count: int, **values: object) -> str:
    """Sentence of the template for one or of that for many; another language may have more forms.

    >>> say_many("{count} line", "{count} lines", count=3)
    '3 lines'
    """
    template = _current().catalogue.ngettext(one, many, count)
    return _current().vformat(template, (), {"count": count, **values})


def translate(text: str, context: str = "") -> str:
    """English text of a table in the language of the user, its symbols too; one that is not in the catalogue stays.

    Args:
        text: the text; what a user wrote is not for it, but for ``named``.
        context: context in the catalogue: ``unit``, ``value``, …
    """
    if _current() is ENGLISH:
        return latin(text) if context in ("", "comment", "symbol") else text
    catalogue = _current().catalogue
    if context or not text:  # of nothing gettext gives the head of the catalogue
        return catalogue.pgettext(context, text)
    sentence = catalogue.gettext(text)
    return catalogue.pgettext("value", text) if sentence == text else sentence


def deferred(text: str) -> str:
    """The text itself, marked for the catalogue: it is translated where it is used."""
    return text


def named(name: str | None) -> str:
    """Name of a clutch, as given; only one that ships with the program has one in every language."""
    return translate(name, "name") if name else ""


def localized(number: str) -> str:
    """Number, given as Python writes it, as people write it in the language of the user."""
    return _current().number(number)


def measured(value: float, unit: str, digits: int = 6) -> str:
    """Value in SI, shown in the unit of that name, which is "1" of a pure number.

    >>> measured(2000.0, "kN"), measured(0.5, "1")
    ('2 kN', '0.5')
    """
    return _current().format_field(value, f".{digits}g {typeset(unit)}")


def percent(share: float) -> str:
    """Share of a limit, never as 100 % what is below or beyond it.

    >>> percent(0.99952), percent(0.5), percent(1.00001)
    ('99.95%', '50.0%', '100.001%')
    """
    digits = next((digits for digits in range(1, 8) if float(f"{share:.{digits + 2}f}") != 1), 1)
    return localized(f"{share:.{digits}%}")


def with_unit(number: str, unit: str) -> str:
    """Number with its unit, none where it is pure; only the sign of a degree stands close to its number."""
    return number if unit in ("", "–") else f"{number}{unit if unit == '°' else f' {unit}'}"


_LATIN = table("""\
н = n; т = T; п = sp; ш = ball; ц = c; д = dyn; в = sh; р = s; cp = mean; ср = pub; муф = c; маш = m; дв = mot;
пуск = st; тр = fr; зад = req; ном = nom""")
"""Letters of an index of the papers → Latin ones, of the English word that they stand for."""
_LATIN_OF = table("F_п = cl; T_п = pot; K_п = n; m_п = st; T_муф = exp; T_маш = mach; σ_т τ_т = y")
"""Latin index of a symbol in which the Cyrillic one stands for another word."""
_INDEX_WORD = re.compile(r"[а-яё]+|(?<![^\W\d_])cp(?![^\W\d_])")
_INDEXED = re.compile(r"(?<![^\W_])[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*")
_QUOTED = re.compile("(«[^»]*»)")
_SYMBOL = re.compile(
    r"\b\w+ wanted|(?<=\)_)opt\b| or (?=κ)|"
    r"(?<![^\W_])(?:[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*|(?:arc)?tanh?|cot)(?![^\W_])"
)
_WORD = re.compile(r"[^\W\d_]{2,}")


def latin(text: str) -> str:
    """Text with the indices of the papers' symbols in Latin letters; what is quoted, in «», stays as it is printed.

    >>> latin("T_н.маш, K_т,act"), latin("F_п"), latin("F_п2"), latin("f_1cp"), latin("T'_п")
    ('T_n,m, K_T,act', 'F_cl', 'F_sp2', 'f_1mean', "T'_pot")
    """
    return _unquoted(_INDEXED, _latin_symbol, text) if "_" in text else text


def _latin_symbol(symbol: re.Match[str]) -> str:
    letter, _, index = symbol[0].partition("_")
    first, *others = re.split("[.,]", index)
    own = _LATIN_OF.get(f"{letter.rstrip(chr(39))}_{first}")
    parts = [_INDEX_WORD.sub(lambda word: _LATIN.get(word[0], word[0]), part) for part in (own or first, *others)]
    return f"{letter}_{','.join(parts)}"


def native(text: str) -> str:
    """Text with symbols in the letters of the user's language: ``F_cl`` or ``F_п``, ``tan α`` or ``tg α``.

    What is quoted, in «», stays as it is printed.
    """
    if _current() is ENGLISH:
        return latin(text)
    return _unquoted(_SYMBOL, _native, text)


def _unquoted(pattern: re.Pattern[str], replace: Callable[[re.Match[str]], str], text: str) -> str:
    return "".join(part if part[:1] == "«" else pattern.sub(replace, part) for part in _QUOTED.split(text))


def _native(symbol: re.Match[str]) -> str:
    whole = translate(symbol[0], "symbol")
    return whole if whole != symbol[0] else _WORD.sub(lambda word: translate(word[0], "symbol"), whole)


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Hint ``"; did you mean 'x'?"`` at the nearest known word, or nothing when none is near.

    >>> did_you_mean("frction", ["friction", "drive"])
    "; did you mean 'friction'?"
    """
    known = list(known)
    if word in known or len(word) > _LONGEST_WORD:
        return ""
    from difflib import get_close_matches

    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(word.casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""


_LONGEST_WORD = 60
"""Letters of a word that is worth comparing."""


_HIDDEN = re.compile(
    "[\x00-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\U000e0000-\U000e007f]"
)
"""Characters that act on a terminal, turn the direction of writing, are not seen, or are none (undecodable bytes)."""


def printable(text: str, *, lines: bool = False) -> str:
    r"""Text that may hold anything (names, keys, arguments), its hidden characters escaped as in JSON.

    Args:
        text: any text.
        lines: True if ends of lines are meant as such.

    >>> print(printable("a\x1b[31m \u202eb\n"))
    a\u001b[31m \u202eb\n
    """

    def escaped(hidden: re.Match[str]) -> str:
        import json

        return hidden[0] if lines and hidden[0] == "\n" else json.dumps(hidden[0])[1:-1]

    return _HIDDEN.sub(escaped, text)


def is_unicode(stream: Any) -> bool:
    """True if a stream takes any text."""
    return (getattr(stream, "encoding", "") or "").lower().replace("-", "").startswith("utf")
