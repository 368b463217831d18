"""Commands about the papers behind the numbers: equations, explain, reproduce."""

from typing import Annotated

from typer import Argument, Option

from ..analysis.registry import EXPLAINED, StressRule
from ..errors import AfmcalcError
from .help import completing
from .options import Common, SpecArgument, with_common

PaperOption = Annotated[list[str] | None, Option("--paper", metavar="KEY", help="F11, S19, S21 or S22; repeatable.")]


@with_common
def explain(
    command: Annotated[
        str,
        Argument(
            metavar="COMMAND",
            autocompletion=completing("explained"),
            help=f"{', '.join(EXPLAINED[:-1])} or {EXPLAINED[-1]}.",
        ),
    ],
    spec: SpecArgument = None,
    model: Annotated[StressRule | None, Option(help="For life: the rule for the damaging stress.")] = None,
    *,
    common: Common,
) -> None:
    """A calculation step by step: formula, numbers, value, source.

    \b
    afmcalc explain torque clutch.toml
    afmcalc explain overload --format markdown > overload.md
    """  # noqa: D301
    from ..spec import resolved

    if model and command != "life":
        raise AfmcalcError("explain: --model belongs to life")
    common.keep(spec)
    given = common.read(spec, command)
    result, findings = common.ask(command, given, model)
    common.emit(result, findings, resolved(given))


@with_common
def equations(
    paper: PaperOption = None,
    id_: Annotated[
        list[str] | None, Option("--id", metavar="ID", help='A formula, e.g. "S21 (15)"; repeatable.')
    ] = None,
    misprints: Annotated[bool, Option("--misprints", help="The papers' misprints and contradictions.")] = False,
    *,
    common: Common,
) -> None:
    """Every formula of the papers and what implements or covers it.

    \b
    afmcalc equations --paper S21
    afmcalc equations --id "S21 (15)"
    afmcalc equations --misprints
    """  # noqa: D301
    common.without_clutch(paper or [], id_ or [], show_misprints=misprints)


@with_common
def reproduce(
    paper: PaperOption = None,
    figure: Annotated[
        list[str] | None,
        Option(
            metavar="NAME",
            autocompletion=completing("figure"),
            help="The points of a figure's curves, e.g. S22-3; repeatable.",
        ),
    ] = None,
    *,
    common: Common,
) -> None:
    """Recompute every printed figure and claim of the papers.

    \b
    afmcalc reproduce
    afmcalc reproduce --figure S22-3 --format csv
    afmcalc reproduce --paper S22 --format csv
    """  # noqa: D301
    common.without_clutch(paper or [], figure)
