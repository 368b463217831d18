"""The formats a result is printed in."""

from collections.abc import Callable
from importlib import import_module

from ...result import Output

FORMATS = ("table", "json", "csv", "markdown")
"""Names of the formats that a user chooses from; a notebook asks for html too."""

Render = Callable[[Output, bool], str]
"""``render(output, terminal)`` → the text for standard output or a file."""

_HOMES = {"markdown": ("markup", "markdown"), "html": ("markup", "html")}


def renderer(name: str) -> Render:
    """Return the render function of a format, importing only its module."""
    module, function = _HOMES.get(name, (name, "render"))
    return getattr(import_module(f".{module}", __package__), function)
