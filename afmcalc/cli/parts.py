"""Commands about what a trip does to the parts, and the parts themselves."""

from typing import Annotated

import typer

from ..analysis.registry import SpringKind, SpringOrder
from ..errors import AfmcalcError
from ..messages import say
from .options import Common, SpecArgument, with_common
from .run import build_from, calculate, emit, write_spec


@with_common
def heat(spec: SpecArgument = None, *, common: Common) -> None:
    """Work, temperature and wear of a trip, and how often it may be.

    \b
    afmcalc heat clutch.toml
    afmcalc heat clutch.toml --set drive.speed='1430 rpm' --set drive.cut_off='0.5 s'
    afmcalc heat clutch.toml --json
    """  # noqa: D301
    calculate(common, spec)


@with_common
def effects(spec: SpecArgument = None, *, common: Common) -> None:
    """What the torque law neglects, in numbers: splines, sliding cams, centrifugal force, wear.

    \b
    afmcalc effects clutch.toml
    afmcalc effects --set control_unit.wall_friction=0.1
    afmcalc effects clutch.toml --set friction_group.spline_friction=0.15 --json
    """  # noqa: D301
    calculate(common, spec)


@with_common
def springs(
    spec: SpecArgument = None,
    sort: Annotated[
        SpringOrder | None,
        typer.Option("--sort", help="What is to be small.  [default: length where a stiffness is wanted, else wear]"),
    ] = None,
    top: Annotated[int, typer.Option("--top", min=1, max=1000, help="How many to tell of each spring.")] = 10,
    kind: Annotated[SpringKind, typer.Option("--kind", help="Disc springs, coil springs, or both.")] = "any",
    tolerance: Annotated[
        float, typer.Option("--tolerance", min=0, max=10, help="How far the stiffness may be off, relative.")
    ] = 0.1,
    pick: Annotated[
        list[int] | None,
        typer.Option("--pick", metavar="N", help="Write the spec with this one to --output; one for each spring."),
    ] = None,
    *,
    common: Common,
) -> None:
    """Disc stacks and coil springs that give the forces and stiffnesses of a clutch, within the room there is.

    \b
    afmcalc springs clutch.toml --sort wear --kind disc
    afmcalc springs clutch.toml --set closing_spring.room.outer_diameter='120 mm' --top 20
    afmcalc springs clutch.toml --pick 3 --output sprung.toml
    afmcalc springs clutch.toml --pick 3 --json | afmcalc check -
    """  # noqa: D301
    if pick and common.output in (None, "-") and common.chosen_format != "json":
        raise AfmcalcError(
            say("springs --pick writes the spec with the spring: name a file with --output, or pass it on with --json")
        )
    options = {"sort": sort, "top": top, "kind": kind, "tolerance": tolerance}
    if not pick:
        calculate(common, spec, lambda clutch: options)
        return
    from ..analysis.springs.springs import picked
    from ..analysis.springs.springs import springs as found

    common.keep(spec, writes="spec")
    clutch = build_from(spec, common)
    with common.bar():
        result, findings = found(clutch, sort, top, kind, tolerance)
    data = picked(clutch, result, pick)
    emit(common.to_standard_output(), result, findings, data)
    if common.output in (None, "-"):
        return
    write_spec(data, common, say("With a part chosen by afmcalc springs."))
    common.wrote(say("wrote the spec with its spring to {output}", output=common.output))
