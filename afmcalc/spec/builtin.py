"""The example specs, which ship with the package; one of them is the built-in default."""

from pathlib import Path

DEFAULT = "default"


def folder() -> Path:
    """Where the examples are: inside the installed package, or beside it in a checkout."""
    packaged = Path(__file__).parents[1] / "configs"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "configs"


def default_text() -> str:
    """Text of the built-in base clutch."""
    return example_text(DEFAULT)


def example_text(name: str) -> str:
    """Text of the example ``name`` (a file of ``configs/`` without its ending)."""
    return (folder() / f"{name}.toml").read_text(encoding="utf-8")
