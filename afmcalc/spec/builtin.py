"""The example specs, which ship with the package; one of them is the built-in default."""

from pathlib import Path

from ..errors import AfmcalcError
from ..messages import say

DEFAULT = "default"
PREFIX = "example:"
"""What makes the name of an example a source."""


def folder() -> Path:
    """Where the examples are: inside the installed package, or beside it in a checkout."""
    packaged = Path(__file__).parents[1] / "configs"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "configs"


def names() -> list[str]:
    """Names of the examples, files of ``configs/`` without their ending."""
    return sorted(path.stem for path in folder().glob("*.toml"))


def default_text() -> str:
    """Text of the built-in base clutch."""
    return example_text(DEFAULT)


def example_text(name: str) -> str:
    """Text of an example.

    Raises:
        AfmcalcError: there is none of that name.
    """
    if name not in (known := names()):
        from .suggest import did_you_mean

        hint = did_you_mean(name, known) or say("; there are: {names}", names=", ".join(known))
        raise AfmcalcError(say("{prefix}{name}: no such example{hint}", prefix=PREFIX, name=name, hint=hint))
    return (folder() / f"{name}.toml").read_text(encoding="utf-8")
