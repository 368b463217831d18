"""Names that can be given on a command line, with their meanings: for ``afmcalc help`` and shell completion."""

from collections.abc import Callable

from ..messages import native, translate

Named = list[tuple[str, str]]
"""Pairs of a name and its meaning."""


def names_of(kind: str) -> Named:
    """Names of a kind (plot, example, target, path, swept; any other kind: symbols), each with its meaning."""
    from ..analysis.registry import PLOTS
    from ..equations.terms import TERMS
    from ..spec.keys import ALIASES, keys
    from ..spec.parse import example_names

    about = {path: translate(key.description) for path, key in keys().items()}
    symbols = [(symbol, f"{path}, {about[path].partition(';')[0]}") for symbol, path in ALIASES.items()]
    match kind:
        case "plot":
            return [(name, translate(plot.about)) for name, plot in PLOTS.items() if name not in DRAWINGS]
        case "example":
            return [(name, "") for name in example_names()]
        case "target":
            from ..analysis.solve import is_quantity

            terms = {name: own for name, own in TERMS.items() if is_quantity(name)}
            named = {name: f"{native(own.symbol)}, {translate(own.meaning)}" for name, own in terms.items()}
            required = [key for key in keys().values() if key.path.startswith("requirements.")]
            for key in required:
                meaning = about[key.path].partition(",")[0]
                named[key.path.partition(".")[2]] = f"{native(key.symbol or '')}, {meaning}"
            return [*named.items()]
        case "path":
            return [*about.items()]
        case "swept":
            return [("zC", translate("reduced gain")), *symbols]
    return symbols


DRAWINGS = {"section": "layout", "layout": "layout", "pocket": "pocket", "synthesize": "pocket"}
"""Drawing to scale, which is not a plot → the command that writes the drawing with --output."""


def completing(kind: str, end: str = "") -> Callable[[str], Named]:
    """Completion callback for a kind: names that begin with the typed text, each followed by ``end``."""
    return lambda incomplete: [(name + end, about) for name, about in names_of(kind) if name.startswith(incomplete)]
