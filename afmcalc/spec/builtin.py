"""The example specs, which ship with the package; one of them is the built-in default."""

import re
from pathlib import Path

from ..errors import AfmcalcError
from ..messages import named, say, translate

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


_DRIVE = re.compile(r"(?ms)^\[drive\].*?(?=^(?:# )?\[(?!drive)|\Z)")
"""The blocks of a drive, up to the block that follows."""
_OF_A_HUB = re.compile(r"(?m)^# (hub_inertia = \S+ \S+)")


def in_a_drive(text: str, *, hub: bool) -> str:
    """Return an example of a clutch with the drive of the example that has one.

    Args:
        text: the clutch.
        hub: whether its hub moves by itself, and has an inertia.
    """
    found = _DRIVE.search(example_text("drive"))
    assert found is not None
    drive = _OF_A_HUB.sub(lambda key: f"{key[1]}  ", found[0]) if hub else found[0]
    return _DRIVE.sub(lambda own: drive, text, count=1)


_NAME = re.compile(r'(?m)(?<=^name = ").*(?="$)')
_OPTIONAL = re.compile(r"# (?=\[|[\w.\"]+ = )")
"""Before a key or block that is there to be taken up."""


def comment(line: str) -> str:
    """Return the comment of a line of an example, or nothing.

    >>> comment('# sleeve_depth = "25 mm"     # of the sleeve'), comment("# A clutch."), comment("[drive]")
    ('of the sleeve', 'A clutch.', '')
    """
    if optional := _OPTIONAL.match(line):
        line = line[optional.end() :]
    before, mark, said = line.partition("# ")
    return said if mark and before.count('"') % 2 == 0 else ""


def annotated(text: str) -> str:
    """Return an example with its comments, and its name, in the language of the user."""
    told = "".join(
        line.removesuffix(said) + translate(said, "comment") + "\n"
        for line in text.splitlines()
        for said in (comment(line),)
    )
    return _NAME.sub(lambda found: named(found[0]), told, 1)
