"""Commands that go from what is wanted to a clutch."""

from typing import Annotated

from typer import Argument, Option

from ..errors import AfmcalcError
from ..messages import say
from .names import completing
from .options import Common, SaveOption, SpecArgument, with_common


@with_common
def solve(
    target: Annotated[
        str,
        Argument(
            metavar="TARGET=VALUE",
            help="What is wanted, e.g. accuracy_factor=2 or torque_max='300 Nm'.",
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
    beyond_limit: Annotated[bool, Option("--beyond-limit", help="Go past the gain limit of the variant.")] = False,
    *,
    common: Common,
) -> None:
    """One key from one wanted quantity.

    Wanted can be any quantity by its name in JSON or its symbol, at a friction too (torque_at_f_max), and whatever a
    requirement judges. The quantity is calculated at 400 values over the range of the key; between two of them that lie
    on either side of what is wanted the value is found. What needs an event (peak_torque, temperature), a life or parts
    is calculated for one clutch at a time, at 40 values around that of the spec.

    \b
    afmcalc solve --for C accuracy_factor=2.0 clutch.toml
    afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -
    afmcalc solve --for z torque_max=300 clutch.toml --save solved.toml
    afmcalc solve --for F peak_torque=450 drive.toml
    """  # noqa: D301
    from ..analysis.solve import parse_target
    from ..spec import resolved
    from ..spec.edit import value_at

    if spec is not None and "=" in spec and "=" not in target:
        target, spec = spec, target
    common.keep(spec, save=save)
    name, wanted, questions = parse_target(target)
    clutch = common.build(spec)
    result, solved, findings = common.ask(clutch, key, name, wanted, beyond_limit=beyond_limit)
    if result.roots or common.chosen_format == "json":
        common.emit(result, [*questions, *findings], resolved(solved.spec))
    if not result.roots:
        raise AfmcalcError(findings[-1].message)
    if save:
        common.save_spec(clutch.spec, {result.path: value_at(solved.spec, result.path)}, solved.spec, save)


@with_common
def tolerance(
    spec: SpecArgument = None,
    *,
    common: Common,
) -> None:
    """Torque over tolerances and scatter: quantiles, risks, life, what scatters most.

    What scatters stands in the [tolerance] block of the spec; afmcalc init --kind tolerance writes an example.

    \b
    afmcalc tolerance clutch.toml
    afmcalc tolerance clutch.toml --set tolerance.samples=2_000_000 --json
    """  # noqa: D301
    common.calculate(common.clutch(spec))


@with_common
def design(
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
        Option(
            metavar="QUANTITY", help="Sort the front by this, least first: any numeric column, by its name in JSON."
        ),
    ] = None,
    *,
    common: Common,
) -> None:
    """The best clutches for what is required: the Pareto front of a grid.

    SPEC is a clutch with requirements and a [search] of keys to vary, such as "control_unit.gain" = "0:1:21"; an
    example is written by afmcalc init --from requirements. A clutch of the front holds every requirement and passes
    check, and no other candidate is better in one of the objectives and as good in the others. They are quantities to
    be small, or large with a minus: objectives = ["closing_force", "-gain_limit"].

    \b
    afmcalc design requirements.toml --sort accuracy_factor --all
    afmcalc design requirements.toml --pick compromise --save clutch.toml
    afmcalc design requirements.toml --pick 3 --json | afmcalc check -
    """  # noqa: D301
    from ..analysis.design import picked, shown
    from ..spec import resolved

    common.keep(spec, save=save)
    if save and pick is None:
        raise AfmcalcError("--save writes the clutch of --pick: give both")
    given = common.read(spec)
    result, findings = common.ask(given)
    row = chosen = None
    if result.front and (pick is not None or common.chosen_format == "json"):
        row, chosen = picked(given, result, pick or result.compromise or 1)
    if row and pick is not None:
        result = result.model_copy(update={"front": [row]})
    front = shown(result, sort, whole=all_rows or common.chosen_format not in ("table", "markdown"))
    if more := len(result.front) - len(front.front):
        common.note(say("the front has {count} more: --all shows them", count=more))
    nothing = [finding for finding in findings if finding.code == "no-candidate"]
    if common.chosen_format != "json":  # there it is the error below
        findings = [finding for finding in findings if finding not in nothing]
    common.emit(front, findings, resolved(chosen) if chosen else None)
    if nothing:
        raise AfmcalcError(nothing[0].message)
    if save and row and chosen:
        common.save_spec(given, {**row.changes, "search": None}, chosen, save)
