"""Axes of a sweep as written on the command line: which key is meant."""

from collections.abc import Iterable

from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...messages import say
from ...spec import Spec
from ...spec.names import elsewhere, names, path_of
from ...spec.paths import ALIASES, keys
from ...spec.rules import variants_of
from ...spec.suggest import did_you_mean
from ...spec.walk import Key
from .grid import Axis


def find_key(name: str) -> Key:
    """Return the numeric spec key that ``name`` (a path, a key's name or a symbol) means.

    Raises:
        AfmcalcError: no such key, or a key that is no number.
    """
    path, known = path_of(name), keys()
    if path is None:
        symbols = ", ".join(ALIASES)
        hint = elsewhere(name) or did_you_mean(name, [*ALIASES, *names()])
        raise AfmcalcError(
            say(
                "{name!r:.80} is no key or symbol{hint}; symbols: {symbols}; keys: by name or path, as in the spec",
                name=name,
                hint=hint,
                symbols=symbols,
            )
        )
    if known[path].unit is None:
        raise AfmcalcError(say("{name!r} is not a number and cannot be swept", name=name))
    return known[path]


def parse_axes(texts: Iterable[str], clutch: Clutch, *, band: bool = False) -> list[Axis]:
    """Read the axes of a sweep; ``band`` takes dT for the scatter band, of which a life can be told."""
    from ..life import band_axis

    return [
        band_axis(text, clutch) if band and text.partition("=")[0].strip() == "dT" else parse_axis(text, clutch.spec)
        for text in texts
    ]


def parse_axis(text: str, spec: Spec) -> Axis:
    """Read ``NAME``, ``NAME=start:stop:count`` or ``NAME=v1,v2,…`` (values in SI or with units).

    Raises:
        AfmcalcError: the text cannot be read.
    """
    name, separator, given = text.partition("=")
    name = name.strip()
    key = find_key("C" if name == "zC" else name)
    if (only := variants_of(key.path)) and spec.variant not in only:
        raise AfmcalcError(
            say(
                "--sweep {text:.80}: {path} is only for {only}, not {variant!r}",
                text=text,
                path=key.path,
                only=", ".join(only),
                variant=spec.variant,
            )
        )
    scale = 1 / (spec.friction_group.pairs - spec.bypass_pairs) if name == "zC" else 1.0
    # here, not above: it loads NumPy, which only a sweep needs
    from .ranges import default_range, parse_values

    values = parse_values(text, given, key.unit or "1") if separator else default_range(key, spec) / scale
    return Axis(name, key, values, scale)
