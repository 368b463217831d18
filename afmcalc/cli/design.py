"""Commands that go from what is wanted to a clutch."""

from typing import Annotated

from typer import Argument, Option

from ..errors import AfmcalcError
from ..messages import say
from .help import completing
from .options import Common, SpecArgument, with_common


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
    parameter: Annotated[
        str,
        Option(
            "--for",
            metavar="NAME",
            help="Parameter to solve for: C, F, z, z1, R, c1, c2, or its key.",
            autocompletion=completing("parameter"),
        ),
    ] = "C",
    beyond_limit: Annotated[bool, Option("--beyond-limit", help="Go past the gain limit of the variant.")] = False,
    *,
    common: Common,
) -> None:
    """One parameter from one wanted quantity.

    Wanted can be what the torque law gives, and whatever check judges by a requirement: peak_torque, temperature, work,
    exceedance, cycles, contact_pressure and others. Those are calculated for one clutch at a time, up to a second each,
    at some values of the parameter around that of the spec, and then between two of them.

    \b
    afmcalc solve --for C accuracy_factor=2.0 clutch.toml
    afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -
    afmcalc solve --for z torque_max=300 clutch.toml
    afmcalc solve --for F peak_torque=450 drive.toml
    """  # noqa: D301
    from ..analysis.solve.solve import in_order, parse_target
    from ..spec import resolved

    target, spec = in_order(target, spec)
    common.keep(spec)
    name, wanted, questions = parse_target(target)
    clutch = common.build(spec)
    result, solved, findings = common.ask(clutch, parameter, name, wanted, beyond_limit=beyond_limit)
    common.emit(result, [*questions, *findings], resolved(solved.spec))


@with_common
def tolerance(
    spec: SpecArgument = None,
    threads: Annotated[
        int | None, Option(min=1, help="How many threads; the digits stay the same.  [default: all]")
    ] = None,
    *,
    common: Common,
) -> None:
    """Torque over tolerances and scatter: quantiles, risks, life, what scatters most.

    What scatters stands in the [tolerance] block of the spec; afmcalc init --kind tolerance writes an example.

    \b
    afmcalc tolerance clutch.toml
    afmcalc tolerance clutch.toml --set tolerance.samples=10_000_000 --json
    afmcalc tolerance clutch.toml --set tolerance.method=quasi-monte-carlo
    """  # noqa: D301
    common.calculate(common.clutch(spec), threads=threads)


@with_common
def design(
    requirements: Annotated[
        str, Argument(metavar="REQUIREMENTS", help="TOML or JSON file of what is wanted, - for standard input.")
    ],
    pick: Annotated[
        str | None, Option(metavar="N|knee", help="Take this clutch of the front as a spec; --output writes it.")
    ] = None,
    top: Annotated[
        int | None, Option(metavar="N", min=1, help="Show so many of the front.  [default: 40 in tables]")
    ] = None,
    sort: Annotated[
        str | None,
        Option(
            metavar="QUANTITY", help="Sort the front by this, least first: any numeric column, by its name in JSON."
        ),
    ] = None,
    simulate: Annotated[
        bool,
        Option(
            "--simulate/--no-simulate", help="Hold the front to what has to be simulated or sampled, or do not yet."
        ),
    ] = True,
    explain: Annotated[
        str | None, Option(metavar="N|knee", help="Show the neighbours of this clutch, and what each gives up.")
    ] = None,
    misses: Annotated[
        bool, Option("--misses", help="Tell the nearest miss of each requirement too, and what to relax.")
    ] = False,
    *,
    common: Common,
) -> None:
    """The best clutches for what is wanted: the exact Pareto front.

    An example is written by afmcalc init --kind requirements. A number of the front means the same clutch in the table,
    the CSV, the plot and for --pick, however the table is sorted. Between the points of a range every objective is made
    as small as it goes; with closing_forces, a curved pocket, or what has to be simulated, the front is that of the
    points; --no-simulate looks without simulating. With --pick a clutch gets round figures that hold every limit, is
    calculated again with them and shown alone, with what a check says of its requirements and limits; --output FILE
    gets it as a spec that passes a check.

    \b
    afmcalc design requirements.toml --sort accuracy_factor --top 10
    afmcalc design requirements.toml --explain knee
    afmcalc design requirements.toml --no-simulate
    afmcalc design requirements.toml --pick 3 --output clutch.toml
    afmcalc design requirements.toml --pick 3 --json | afmcalc check -
    """  # noqa: D301
    from ..analysis.design.design import check_sort, focused, shown, with_neighbours
    from ..analysis.design.pick import with_picked, with_verdict
    from ..spec import resolved
    from ..spec.requirements import read_requirements

    common.keep(requirements, spec=pick is not None)
    check_sort(sort)
    need = read_requirements(requirements, common.overrides)
    result, findings = common.ask(need, misses=misses or None, simulate=simulate)
    printed = common if pick is None else common.to_standard_output()
    spec = None
    if pick is not None and result.front:
        with common.bar():
            result, chosen = with_picked(need, result, pick)
            result, remarks = with_verdict(result, chosen)
        findings = [*dict.fromkeys([*findings, *remarks])]
        spec = resolved(chosen)
    if explain is not None and result.front:
        result = with_neighbours(result, explain)
    if top is None and printed.chosen_format != "json":
        if spec or result.neighbours is not None:
            result = focused(result)
        elif result.on_front > _IN_TABLES and printed.chosen_format != "csv":
            top = _IN_TABLES
            common.note(say("{top} of {count} shown; --top {count} shows all", top=top, count=result.on_front))
    empty = [finding for finding in findings if finding.code == "no-candidate"]
    if printed.chosen_format != "json":  # there it is the error below
        findings = [finding for finding in findings if finding not in empty]
    printed.emit(shown(result, sort, top), findings, spec)
    if empty:
        raise AfmcalcError(empty[0].message)
    if spec and common.output:
        number = result.picked[0].number
        about = say("Number {pick} of the front of afmcalc design.", pick=number)
        common.write_spec(spec, about, say("wrote number {pick} to {output}", pick=number, output=common.output))


_IN_TABLES = 40
"""Clutches of a front that a table shows unasked."""
