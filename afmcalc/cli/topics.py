"""The command that shows what the help of single commands leaves out: common options, and names that can be given."""

from typing import Annotated

from typer import Argument

from ..errors import AfmcalcError
from ..messages import did_you_mean, translate
from .names import Named, names_of
from .options import COMMON, LANG

TOPICS = ("options", "keys", "quantities", "plots")


def help(
    topic: Annotated[
        str,
        Argument(
            metavar="TOPIC",
            autocompletion=lambda incomplete: [each for each in TOPICS if each.startswith(incomplete)],
            help="options, keys, quantities, plots; or a command.",
        ),
    ],
) -> None:
    """Options of every command, and names that can be given: keys of a spec, quantities, plots.

    \b
    afmcalc help options
    afmcalc help quantities
    """  # noqa: D301
    if topic not in TOPICS:
        from .main import COMMANDS

        hint = did_you_mean(topic, [*TOPICS, *COMMANDS])
        raise AfmcalcError("no help on {topic!r:.80}{hint}; topics: {topics}", topic=topic, hint=hint, topics=[*TOPICS])
    match topic:
        case "options":
            rows = _common_options()
        case "keys":
            rows = [*names_of("swept"), *names_of("path")]
        case "quantities":
            rows = names_of("target")
        case _:
            rows = names_of("plot")
    _print(rows)


def _common_options() -> Named:
    """Return the options that commands share, each with its help, as the parser has them."""
    from .main import application

    options = [each for each in application(["torque"]).commands["torque"].params if each.name in COMMON]
    rows = [(f"{', '.join(each.opts)} {each.metavar or ''}", each.help) for each in options]
    return [*rows, ("--lang NAME", translate(LANG))]


def _print(rows: Named) -> None:
    """Print names in a column, with the meaning of each beside it."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    from ..render.formats.table import columns

    grid = Table.grid(padding=(0, 2))
    for name, about in rows:
        grid.add_row(Text(name, no_wrap=True), Text(about))
    Console(width=columns(terminal=True), height=1, highlight=False).print(grid)
