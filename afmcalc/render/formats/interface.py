"""What a format is, and which there are."""

from collections.abc import Callable
from importlib import import_module

from ...result import Output

FORMATS = ("table", "json", "csv", "markdown")
"""Names of the formats; each is a module of this package with a ``render`` function."""

Render = Callable[[Output, bool], str]
"""``render(output, terminal)`` → the text for standard output or a file."""


def renderer(name: str) -> Render:
    """Return the render function of a format, importing only that one."""
    render: Render = import_module(f".{name}", __package__).render
    return render
