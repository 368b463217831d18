"""Commands solve, tolerance and design."""

from typing import Annotated

from typer import Argument, Option

from ..errors import AfmcalcError
from ..messages import say
from .options import Common, SaveOption, SpecArgument, completing


def solve(
    common: Common,
    target: Annotated[
        str,
        Argument(
            metavar="TARGET=VALUE",
            help="Wanted quantity, e.g. accuracy_factor=2 or torque_max='300 Nm'.",
            autocompletion=completing("target", "="),
        ),
    ],
    spec: SpecArgument = None,
    key: Annotated[
        str,
        Option(
            "--for",
            metavar="KEY",
            help="Key to solve for, by symbol or path.",
            autocompletion=completing("parameter"),
        ),
    ] = "C",
    save: SaveOption = None,
    beyond_limit: Annotated[bool, Option("--beyond-limit", help="Search beyond the gain limit.")] = False,
) -> None:
    """Find the value of one key that gives a wanted quantity.

    The quantity is given by its name in JSON or its symbol, also in a case (torque_at_f_max), or is one that a
    requirement limits. It is calculated at 400 values of the key; each root is found between two neighbours on either
    side of the target. What needs an event (peak_torque, temperature), a life or parts is calculated at 40 values
    around that of the spec.

    \b
    afmcalc solve --for C accuracy_factor=2.0 clutch.toml
    afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -
    afmcalc solve --for z torque_max=300 clutch.toml --save solved.toml
    afmcalc solve --for F peak_torque=450 drive.toml
    """
    from ..analysis.solve import parse_target
    from ..spec.edit import value_at

    if spec is not None and "=" in spec and "=" not in target:
        target, spec = spec, target
    name, wanted, questions = parse_target(target)
    clutch = common.clutch(spec, save=save)
    result, solved, findings = common.ask(clutch, key, name, wanted, beyond_limit=beyond_limit)
    if result.roots or common.chosen_format == "json":
        common.emit(result, [*questions, *findings], solved.spec)
    if not result.roots:
        raise AfmcalcError(findings[-1].message)
    if save:
        common.save_spec(clutch.spec, {result.path: value_at(solved.spec, result.path)}, save, solved.spec)


def tolerance(common: Common, spec: SpecArgument = None) -> None:
    """Scatter of the torque under tolerances: quantiles, risks, life, and which input causes most of it.

    The tolerances stand in the [tolerance] block of the spec; afmcalc init --kind tolerance writes an example.

    \b
    afmcalc tolerance clutch.toml
    afmcalc tolerance clutch.toml --set tolerance.samples=2_000_000 --json
    """
    common.calculate(common.clutch(spec))


def design(
    common: Common,
    spec: Annotated[str, Argument(metavar="SPEC", help="TOML or JSON file with a [search], - for standard input.")],
    pick: Annotated[
        str | None, Option(metavar="N|compromise", help="Take this clutch of the front; --save writes it.")
    ] = None,
    save: SaveOption = None,
    all_rows: Annotated[
        bool, Option("--all", help="Show the whole front in a table, not ten clutches and the compromise.")
    ] = False,
    sort: Annotated[
        str | None,
        Option(metavar="QUANTITY", help="Sort the front by a numeric column, by its name in JSON; smallest first."),
    ] = None,
) -> None:
    """Best clutches for given requirements: the Pareto front of a grid.

    SPEC is a clutch with requirements and a [search] of keys to vary, such as "control_unit.gain" = "0:1:21"; an
    example is written by afmcalc init --from requirements. A clutch of the front meets every requirement and passes
    check, and no other candidate is better in one objective and at least as good in the others. Objectives are
    quantities to minimise or, with a minus, to maximise: objectives = ["closing_force", "-gain_limit"].

    \b
    afmcalc design requirements.toml --sort accuracy_factor --all
    afmcalc design requirements.toml --pick compromise --save clutch.toml
    afmcalc design requirements.toml --pick 3 --json | afmcalc check -
    """
    from ..analysis.design import picked, shown

    common.keep(spec, save=save)
    if save and pick is None:
        raise AfmcalcError("--save writes the clutch of --pick: give both")
    if pick not in (None, "compromise") and not pick.lstrip("0").isdecimal():
        raise AfmcalcError("--pick {number}: a number of the front from 1, or compromise", number=pick)
    given = common.read(spec)
    result, findings = common.ask(given, sort)
    row = chosen = None
    if result.front and (pick is not None or common.chosen_format == "json"):
        row, chosen = picked(given, result, pick or result.compromise or 1)
    if row and pick is not None:
        result = result.model_copy(update={"front": [row]})
    front = shown(result, sort, whole=all_rows or common.chosen_format not in ("table", "markdown"))
    if more := len(result.front) - len(front.front):
        common.note(say("the front has {count} more: --all shows them", count=more))
    nothing = [finding for finding in findings if finding.code == "no-candidate"]
    if common.chosen_format != "json":  # in JSON the error below says it
        findings = [finding for finding in findings if finding not in nothing]
    common.emit(front, findings, chosen)
    if nothing:
        raise AfmcalcError(nothing[0].message)
    if save and row and chosen:
        common.save_spec(given, {**row.changes, "search": None}, save, chosen)
