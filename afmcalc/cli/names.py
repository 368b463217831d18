"""Names that can be given on a command line, each with its meaning: for ``afmcalc help`` and completion in a shell."""

from collections.abc import Callable
from typing import TypeAlias

from ..messages import native, translate

Named: TypeAlias = list[tuple[str, str]]
"""Names, and the meaning of each."""


def names_of(kind: str) -> Named:
    """Return the names that can be given where a command asks for one of a kind, and what each is."""
    from ..analysis.registry import ANALYSES, EXPLAINED, PLOTS

    match kind:
        case "plot":
            return [(name, translate(plot.about)) for name, plot in PLOTS.items() if name not in DRAWINGS]
        case "explained":
            sections = {name: ANALYSES[name].section for name in EXPLAINED}
            return [(name, translate(section.title if section else "Checks")) for name, section in sections.items()]
        case "example":
            from ..spec.parse import example_names

            return [(name, "") for name in example_names()]
        case "described":
            return [(name, "") for name in ANALYSES]
        case "figure":
            from ..papers import FIGURES

            return [(name, "") for name in FIGURES]
        case "target":
            from ..analysis.solve import is_quantity
            from ..equations.terms import TERMS

            terms = {name: own for name, own in TERMS.items() if is_quantity(name)}
            about = {name: f"{native(own.symbol)}, {translate(own.meaning)}" for name, own in terms.items()}
            return [*({**about, **dict(names_of("required"))}).items()]
    from ..spec.keys import ALIASES, keys

    if kind == "required":
        judged = ((path, key) for path, key in keys().items() if path.startswith("requirements."))
        return [
            (path.partition(".")[2], f"{native(key.symbol or '')}, {translate(key.description).partition(',')[0]}")
            for path, key in judged
        ]
    if kind == "path":
        return [(path, translate(key.description)) for path, key in keys().items()]
    symbols = {
        symbol: f"{path}, {translate(keys()[path].description).partition(';')[0]}" for symbol, path in ALIASES.items()
    }
    return [("zC", translate("reduced gain")), *symbols.items()] if kind == "swept" else [*symbols.items()]


DRAWINGS = {"section": "layout", "layout": "layout", "pocket": "pocket", "synthesize": "pocket"}
"""Drawing to scale → the command that writes it with --output; what it shows is no plot."""


def completing(kind: str, end: str = "") -> Callable[[str], Named]:
    """Return the completion callback of a kind: its names that begin as typed, ``end`` behind each."""
    return lambda incomplete: [(name + end, about) for name, about in names_of(kind) if name.startswith(incomplete)]
