"""The command that lists what ships: materials, examples, disc springs, balls."""

from typing import Annotated, Literal

from typer import Argument

from ..errors import AfmcalcError
from .files import write
from .options import Common, with_common


@with_common
def list_(
    what: Annotated[
        Literal["materials", "examples", "discs", "balls"],
        Argument(metavar="WHAT", help="materials, examples, discs or balls."),
    ],
    name: Annotated[
        str | None,
        Argument(metavar="NAME", help="An example, to print its file; else a SPEC, for the lists of its [catalogues]."),
    ] = None,
    *,
    common: Common,
) -> None:
    """Lists that ship: friction materials, examples (SPEC may be example:NAME), disc springs, balls.

    \b
    afmcalc list materials
    afmcalc list examples
    afmcalc list examples conveyor > conveyor.toml
    afmcalc list balls clutch.toml
    """  # noqa: D301
    if what == "examples":
        if name is None:
            common.without_clutch("examples")
            return
        from ..spec.parse import example_text

        if common.overrides:
            raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name="list examples")
        common.keep()
        write(example_text(name.removeprefix("example:")), common.output, force=common.force, utf8=True)
        return
    common.keep(name)
    lists = common.read(name).lists if name or common.overrides else None
    common.default, common.command = "", what
    common.emit(*common.ask(getattr(lists, what, None)))
