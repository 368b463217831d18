"""Commands that go from what is wanted to a clutch."""

from typing import Annotated

import typer

from .session import Common, SpecArgument, build_from, emit, guarded, naming, with_common


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
