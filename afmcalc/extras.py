"""Optional dependencies: a command whose extra is missing says how to get it."""

from importlib.util import find_spec

from .errors import AfmcalcError
from .messages import joined, say

MODULES = {
    "drive": ("scipy",),
    "explain": ("sympy",),
    "plot": ("matplotlib",),
    "ru": ("babel",),
    "cad": ("ezdxf",),
    "report": ("jinja2", "matplotlib", "latex2mathml"),
}
"""Extra → modules it brings."""


def installed(extra: str) -> bool:
    """Whether the modules of an extra are there."""
    return all(find_spec(name) for name in MODULES[extra])


def need(extra: str) -> None:
    """Make sure that the modules of an extra are installed, without importing them.

    Args:
        extra: name of the extra, as pip knows it.

    Raises:
        AfmcalcError: one is missing.
    """
    missing = [name for name in MODULES[extra] if find_spec(name) is None]
    if missing:
        raise AfmcalcError(
            say(
                "this needs {missing}, not installed here: pip install 'afmcalc[{extra}]'",
                missing=joined(missing, say(" and ")),
                extra=extra,
            )
        )
