"""Design calculator for adaptive friction clutches (АФМ).

>>> import afmcalc
>>> clutch = afmcalc.load()            # the built-in base clutch; or a path, TOML or JSON
>>> round(clutch.torque(0.3), 3)
234.146
"""

TYPE_CHECKING = False  # a type checker takes the name as True; importing it from typing is slow
if TYPE_CHECKING:
    from .errors import AfmcalcError, FileError, SpecError
    from .python import Clutch, build, compare, design, load, loads
    from .spec import Spec, read_spec

__version__ = "0.4.0"
__all__ = [
    "AfmcalcError", "Clutch", "FileError", "Spec", "SpecError", "build", "compare", "design", "load", "loads",
    "read_spec",
]  # fmt: skip

_HOMES = {"errors": ("AfmcalcError", "FileError", "SpecError"), "spec": ("Spec", "read_spec")}
"""Module → its public names; all other public names are in the module ``python``."""


if not TYPE_CHECKING:  # otherwise a type checker would accept any name

    def __getattr__(name: str) -> object:
        """Import a public name on first use, so that ``import afmcalc`` costs nothing."""
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module

        home = next((home for home, names in _HOMES.items() if name in names), "python")
        return getattr(import_module(f".{home}", __name__), name)


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return ["__version__", *__all__]
