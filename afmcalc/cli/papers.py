"""Commands explain, papers and list: derivations, formulas of the papers, built-in lists."""

from typing import Annotated, Literal

from typer import Argument, Option

from ..analysis.registry import EXPLAINED, StressRule
from ..errors import AfmcalcError
from .files import write
from .options import Common, SpecArgument


def explain(
    common: Common,
    command: Annotated[
        str,
        Argument(
            metavar="WHAT",
            help=f"{', '.join(EXPLAINED[:-1])} or {EXPLAINED[-1]}; or the code of an error or warning.",
        ),
    ],
    spec: SpecArgument = None,
    model: Annotated[StressRule | None, Option(help="For life: the rule for the damaging stress.")] = None,
) -> None:
    """A calculation step by step, or what the code of an error or warning means and which keys clear it.

    \b
    afmcalc explain torque clutch.toml
    afmcalc explain overload --format markdown > overload.md
    afmcalc explain contact-force-exceeded clutch.toml
    """
    from ..papers.handbook_text import sections

    if model and command != "life":
        raise AfmcalcError("explain: --model belongs to life")
    if command in sections("en"):
        common.command = "mend"
        common.calculate(common.clutch(spec), code=command)
        return
    common.keep(spec)
    given = common.read(spec, command)
    result, findings = common.ask(command, given, model)
    common.emit(result, findings, given)


def papers(
    common: Common,
    paper: Annotated[list[str] | None, Option(metavar="KEY", help="F11, S19, S21 or S22; repeatable.")] = None,
    id_: Annotated[
        list[str] | None, Option("--id", metavar="ID", help='A formula, e.g. "S21 (15)"; repeatable.')
    ] = None,
    misprints: Annotated[bool, Option("--misprints", help="The papers' misprints and contradictions.")] = False,
    claims: Annotated[bool, Option("--claims", help="Every printed number and claim, recomputed.")] = False,
    figure: Annotated[
        list[str] | None,
        Option(
            metavar="NAME",
            help="With --claims: the points of a figure's curves, e.g. S22-3; repeatable.",
        ),
    ] = None,
) -> None:
    """Every formula of the papers and what implements it; their misprints; their claims recomputed.

    F11 is Fokin and others 2011; S19, S21, S22 Shishkarev 2019, 2021, 2022; M with a number is a misprint in them.

    \b
    afmcalc papers --paper S21
    afmcalc papers --id "S21 (15)"
    afmcalc papers --misprints
    afmcalc papers --claims --paper S22 --format csv
    """
    if figure and not claims:
        raise AfmcalcError("--figure belongs to --claims")
    if not claims:
        common.without_clutch("papers", paper or [], id_ or [], show_misprints=misprints)
    elif id_ or misprints:
        raise AfmcalcError("--claims stands alone, without --id and --misprints")
    else:
        common.without_clutch("claims", paper or [], figure)


def list_(
    common: Common,
    what: Annotated[
        Literal["materials", "examples", "discs", "balls"],
        Argument(metavar="WHAT", help="materials, examples, discs or balls."),
    ],
    name: Annotated[
        str | None,
        Argument(metavar="NAME", help="An example, to print its file; else a SPEC, for the lists of its [catalogues]."),
    ] = None,
) -> None:
    """Lists that ship: friction materials, examples (SPEC may be example:NAME), disc springs, balls.

    \b
    afmcalc list materials
    afmcalc list examples
    afmcalc list examples conveyor > conveyor.toml
    afmcalc list balls clutch.toml
    """
    if what == "examples":
        if name is None:
            common.without_clutch("examples")
            return
        from ..spec.parse import example_text

        common.keep_without_clutch()
        write(example_text(name.removeprefix("example:")), common.output, force=common.force, utf8=True)
        return
    common.keep(name)
    lists = common.read(name).lists if name or common.overrides else None
    common.default, common.command = "", what
    common.emit(*common.ask(getattr(lists, what, None)))
