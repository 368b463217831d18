"""Design calculator for adaptive friction clutches (АФМ).

>>> import afmcalc
>>> clutch = afmcalc.load()            # the built-in base clutch; or a path, TOML or JSON
>>> round(clutch.torque(0.3), 3)
234.146
"""

TYPE_CHECKING = False  # typing costs more than all the rest, and Ctrl-C may come meanwhile
if TYPE_CHECKING:
    from .errors import AfmcalcError, FileError, SpecError
    from .python import Clutch, build, compare, design, load
    from .spec import Spec, read_spec

__version__ = "0.2.0"
__all__ = [
    "AfmcalcError",
    "Clutch",
    "FileError",
    "Spec",
    "SpecError",
    "build",
    "compare",
    "design",
    "load",
    "read_spec",
]

_HOMES = {
    "Clutch": "python",
    "build": "python",
    "compare": "python",
    "design": "python",
    "load": "python",
    "AfmcalcError": "errors",
    "FileError": "errors",
    "SpecError": "errors",
    "Spec": "spec",
    "read_spec": "spec",
}


if not TYPE_CHECKING:  # who checks types is to know every name

    def __getattr__(name: str) -> object:
        """Import a public name on first use, so that ``import afmcalc`` costs nothing."""
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module

        return getattr(import_module(f".{_HOMES[name]}", __name__), name)


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return ["__version__", *__all__]
