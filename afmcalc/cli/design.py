"""Commands that go from what is wanted to a clutch."""

from typing import Annotated

import typer

from .session import Common, SpecArgument, build_from, calculate, emit, guarded, naming, with_common


@with_common
def solve(
    target: Annotated[
        str,
        typer.Argument(metavar="TARGET=VALUE", help="What is wanted, e.g. accuracy_factor=2 or torque_max='300 Nm'."),
    ],
    spec: SpecArgument = None,
    parameter: Annotated[
        str, typer.Option("--for", metavar="NAME", help="Parameter to solve for: C, F, z, z1, R, c1 or c2.")
    ] = "C",
    beyond_limit: Annotated[
        bool, typer.Option("--beyond-limit", help="Go past the gain limit of the variant.")
    ] = False,
    *,
    common: Common,
) -> None:
    """One parameter from one wanted quantity.

    \b
    afmcalc solve --for C accuracy_factor=2.0 clutch.toml
    afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -
    afmcalc solve --for z torque_max=300 clutch.toml
    """  # noqa: D301
    from ..analysis.solve import solve as analysis
    from ..analysis.targets import parse_target
    from ..spec import resolved

    common.keep(spec)
    name, wanted = parse_target(target)
    clutch = build_from(spec, common)
    with naming(spec):
        result, solved, findings = guarded(lambda: analysis(clutch, parameter, name, wanted, beyond_limit=beyond_limit))
    emit("solve", result, findings, common, resolved(solved.spec))


@with_common
def tolerance(
    spec: SpecArgument = None,
    threads: Annotated[
        int | None, typer.Option("--threads", min=1, help="How many threads; the digits stay the same.  [default: all]")
    ] = None,
    *,
    common: Common,
) -> None:
    """Torque over tolerances and scatter: quantiles, risks, life, Sobol indices.

    What scatters stands in the [tolerance] block of the spec; configs/tolerance.toml is an example.

    \b
    afmcalc tolerance clutch.toml
    afmcalc tolerance clutch.toml --set tolerance.samples=10_000_000 --json
    afmcalc tolerance clutch.toml --set tolerance.method=quasi-monte-carlo
    """  # noqa: D301
    from ..analysis.tolerance import tolerance as analysis

    calculate("tolerance", spec, common, lambda clutch: analysis(clutch, threads=threads))
