"""What may stand in the page as markup: our own drawings, subscripts."""

import re
from typing import Any

from markupsafe import Markup, escape

from ...analysis.explain.explain import Derivation
from ...messages import told as message
from ...messages import translate
from ...papers.register import citations
from ...spec.keys import keys
from ..plot.paint import COLOURS, GRID, INK, PAPER, SHADE, WRONG
from ..symbols import native, split


def symbol(text: str, ours: bool = True) -> Markup:
    """Set a symbol with subscripts; what is quoted is not ``ours``, and what is set already stays.

    >>> symbol("T_н < -1")
    Markup('T<sub>н</sub> &lt; −1')
    """
    if isinstance(text, Markup):
        return text
    lower = Markup("<sub>{}</sub>").format
    pieces: list[Any] = [lower(piece) if low else escape(piece) for piece, low in split(_MINUS.sub("−", text), ours)]
    return Markup("").join(pieces)


def cell(text: str) -> Markup:
    """Set a cell of a table: a key as code, a power of ten as one, anything else with its symbols.

    >>> cell("control_unit.gain"), cell("no limit (3.3493e+15)"), cell("1e-11")
    (Markup('<code>control_unit.gain</code>'), Markup('no limit (3.3493·10<sup>15</sup>)'), Markup('10<sup>−11</sup>'))
    """
    if text in keys():
        return Markup("<code>{}</code>").format(text)
    return Markup(_POWER.sub(_power, symbol(text)))  # noqa: S704


def _power(number: re.Match[str]) -> str:
    mantissa = "" if number[1] == "1" else f"{number[1]}·"
    return f"{mantissa}10<sup>{int(number[2])}</sup>".replace("-", "−")


def name_of(path: str) -> str:
    """Name of a key of the spec, without what is said of its use."""
    return _REST.split(translate(keys()[path].description))[0]


def marks(step: Derivation) -> list[str]:
    """Misprints of what is printed instead of a formula that its source does not name."""
    return [mark for mark in dict.fromkeys(MISPRINT.findall(step.differs)) if mark not in MISPRINT.findall(step.source)]


def cited(page: str) -> tuple[str, dict[str, int]]:
    """Set a number where a text cites a source; which source has which number, counted from its first mention."""
    numbers: dict[str, int] = {}
    sources = citations()

    def cite(found: re.Match[str]) -> str:
        key = next((key for key in sources if found[key]), None)
        if key is None:
            return found[0]
        number = numbers.setdefault(key, len(numbers) + 1)
        name = f"{found[key]} " if sources[key][1] and found[key] != key else ""
        if formulas := found["formulas"]:
            many = formulas.count("(") > 1
            mark = message("[{number}, eqs. {at}]" if many else "[{number}, eq. {at}]", number=number, at=formulas)
        else:
            mark = f"[{number}, {found['place']}]" if found["place"] else f"[{number}]"
        return name + mark

    named = "|".join(rf"(?P<{key}>(?<!\w)(?:{pattern})(?!\w))" for key, (pattern, _) in sources.items())
    page = re.sub(rf"(?s:<pre>.*?</pre>|<[^>]*>)|(?:{named}){_WHERE}", cite, page)
    return _BRACKETED.sub(lambda found: found[1] if found[1][:1] == "[" else f"({found[1]})", page), numbers


_WHERE = (
    r"(?:,? (?P<formulas>\(\d[\d.]*[a-z]?\)(?:(?:, |–)\(\d[\d.]*[a-z]?\))*)"
    r"|,? (?P<place>(?:chapters?|ch\.|sec\.|fig\.|гл\.|разд\.|рис\.) \d[\d-]*(?: (?:and|и) \d+)?))?"
)
"""Formulas or chapter of a source, behind its name."""
_BRACKETED = re.compile(r'(?<=<span class="sources">)\[(.*?)\](?=</span>)')
"""A note of sources, which needs no brackets where it begins with a number in brackets."""
MISPRINT = re.compile(r"\bM\d+\b")
_REST = re.compile(r"; |: | \(")


def css_string(text: str) -> Markup:
    """Set a text as a string of a style sheet: whatever is no letter or digit by its code point.

    >>> css_string("A 1</style>")
    Markup('"A\\\\20 1\\\\3c \\\\2f style\\\\3e "')
    """
    plain = "".join(sign if sign.isalnum() else f"\\{ord(sign):x} " for sign in text)
    return Markup(f'"{plain}"')  # noqa: S704


_POWER = re.compile(r"([\d.]+|\(.* ± .*\))e([+-]\d+)")
_MINUS = re.compile(r"(?<![\w.\]})-])-(?=\d)")


def drawing(svg: str, name: str, number: object) -> Markup:
    """Make one of our drawings part of the page: its own ids, the page's colours and width, a name to read out."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>", "", svg, flags=re.DOTALL)
    prefix = f"fig{number}-"
    svg = re.sub(r'\bid="([^"]+)"', rf'id="{prefix}\1"', svg)
    svg = re.sub(r"url\(#", f"url(#{prefix}", svg)
    svg = re.sub(r'href="#', f'href="#{prefix}', svg)
    lines = [(colour, f"--line-{index}") for index, colour in enumerate(COLOURS[:4])]
    inks = (INK, "--ink"), (GRID, "--grid"), (SHADE, "--shade"), (WRONG, "--bad"), (PAPER, "--paper")
    for colour, variable in (*inks, *lines):
        svg = svg.replace(colour, f"var({variable})")
    opening, _, rest = svg.partition(">")
    opening = re.sub(r'\s(?:width|height|version|xmlns(?::\w+)?)="[^"]*"', "", opening)
    label = escape(native(name))
    return Markup(f'{opening} role="img" aria-label="{label}">{rest.strip()}')  # noqa: S704
