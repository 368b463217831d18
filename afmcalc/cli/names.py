"""Names that can be given on the command line, each with what it is: for the help and for completion in a shell."""

from collections.abc import Callable, Iterator

Named = Iterator[tuple[str, str]]


def _about(path: str) -> str:
    from ..messages import translate
    from ..spec.keys import keys

    return f"{path}, {translate(keys()[path].description).partition(';')[0]}"


def parameters() -> Named:
    """What can be solved for."""
    from ..analysis.solve.solve import PARAMETERS
    from ..spec.keys import ALIASES

    for symbol in PARAMETERS:
        yield symbol, _about(ALIASES[symbol])


def targets() -> Named:
    """What can be wanted of a solution."""
    from ..analysis.solve.solve import TARGETS
    from ..messages import translate

    for name, target in TARGETS.items():
        yield name, f"{target.symbols[0]}, {translate(target.description)}"


def swept() -> Named:
    """Symbols of what can be swept."""
    from ..spec.keys import ALIASES

    yield "zC", "reduced gain"
    for symbol, path in ALIASES.items():
        yield symbol, _about(path)


def paths() -> Named:
    """Keys of a spec."""
    from ..messages import translate
    from ..spec.keys import keys

    for path, key in keys().items():
        yield path, translate(key.description)


def plots() -> Named:
    """Kinds of plots."""
    from ..analysis.registry import PLOTS

    for name, plot in PLOTS.items():
        yield name, plot.about


def explained() -> Named:
    """Commands whose calculation can be explained."""
    from ..analysis.registry import ANALYSES, EXPLAINED

    for name in EXPLAINED:
        section = ANALYSES[name].section
        yield name, section.title if section else "Checks"


def described() -> Named:
    """What there is a schema of."""
    from ..analysis.registry import ANALYSES

    yield from dict.fromkeys([*ANALYSES, "requirements"], "").items()


def figures() -> Named:
    """Figures of the papers."""
    from ..papers.figures import FIGURES

    for name in FIGURES:
        yield name, ""


def completing(names: Callable[[], Named], end: str = "") -> Callable[[str], list[tuple[str, str]]]:
    """Return what a shell asks for the names that begin as what is typed does; ``end`` is put behind each."""

    def begun(incomplete: str) -> list[tuple[str, str]]:
        return [(name + end, about) for name, about in names() if name.startswith(incomplete)]

    return begun
