"""Commands that calculate one clutch."""

from typing import Annotated

import typer

from ..errors import AfmcalcError
from .session import Common, SpecArgument, calculate, with_common


@with_common
def torque(
    spec: SpecArgument = None,
    friction: Annotated[
        list[str] | None,
        typer.Option("--friction", metavar="F", help="Also at this friction (unlike materials: F1,F2); repeatable."),
    ] = None,
    *,
    common: Common,
) -> None:
    """Torque, forces and accuracy over the friction range.

    \b
    afmcalc torque clutch.toml
    afmcalc torque clutch.toml --friction 0.15 --friction 0.25 --json
    afmcalc torque clutch.toml --set control_unit.gain=0.8
    """  # noqa: D301
    from ..analysis.torque import torque as analysis

    points = [_friction(text) for text in friction or ()]
    calculate("torque", spec, common, lambda clutch: analysis(clutch, points))


@with_common
def accuracy(
    spec: SpecArgument = None,
    sweep: Annotated[
        list[str] | None,
        typer.Option(
            "--sweep",
            metavar="NAME[=RANGE]",
            help="Sweep a spec path or symbol (C, z, z1, R, F, f_min, f_max, c1, c2, beta) over start:stop:count or "
            "v1,v2,...; repeatable: several make a grid.",
        ),
    ] = None,
    *,
    common: Common,
) -> None:
    """Accuracy factor, its limits and sensitivities, and sweeps of it.

    \b
    afmcalc accuracy --sweep C
    afmcalc accuracy clutch.toml --sweep C=0:1.25:6 --sweep z=4,8,12 --format csv
    afmcalc accuracy clutch.toml --sweep friction.max=0.4:0.8:9 --json
    """  # noqa: D301
    from ..analysis.accuracy import accuracy as analysis
    from ..analysis.sweep import parse_axis

    calculate(
        "accuracy",
        spec,
        common,
        lambda clutch: analysis(clutch, [parse_axis(text, clutch.spec) for text in sweep or ()]),
    )


def _friction(text: str) -> tuple[float, float | None]:
    """Read ``F`` or ``F1,F2``."""
    try:
        values = [float(part) for part in text.split(",")]
    except ValueError:
        values = []
    if len(values) not in (1, 2) or not all(0 <= value < float("inf") for value in values):
        raise AfmcalcError(f"--friction {text}: write a coefficient such as 0.3, or F1,F2 for unlike materials")
    return values[0], values[1] if len(values) == 2 else None
