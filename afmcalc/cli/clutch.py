"""Commands that calculate one clutch."""

from typing import TYPE_CHECKING, Annotated, Any

from typer import Argument, Option

from ..analysis.registry import StressRule
from ..errors import AfmcalcError
from .options import Common, SpecArgument, completing

if TYPE_CHECKING:
    from ..analysis.sweep import Axis
    from ..analysis.torque import Pair
    from ..engines import Clutch

SweepOption = Annotated[
    list[str] | None,
    Option(
        metavar="NAME[=RANGE]",
        autocompletion=completing("swept"),
        help="Sweep a key (afmcalc help keys) over start:stop:count or v1,v2,...; several make a grid.",
    ),
]

FrictionOption = Annotated[
    list[str] | None,
    Option(metavar="F", help="Calculate at this friction too (unlike materials: F1,F2); repeatable."),
]


def torque(
    common: Common,
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    details: Annotated[
        bool, Option("--details", help="Also the loads of each group, the balls, the key and the stop (JSON: always).")
    ] = False,
) -> None:
    """Torque, forces and accuracy over the friction range.

    \b
    afmcalc torque clutch.toml
    afmcalc torque clutch.toml --friction 0.15 --friction 0.25 --json
    afmcalc torque clutch.toml --details --set control_unit.gain=0.8
    """
    from ..render.document import with_details

    with with_details(details):
        common.calculate(common.clutch(spec), friction=frictions(friction))


def accuracy(
    common: Common,
    spec: SpecArgument = None,
    sweep: SweepOption = None,
    columns: Annotated[
        list[str] | None,
        Option(metavar="NAME,…", help="More columns of the sweep: quantities, such as torque_at_f_max."),
    ] = None,
) -> None:
    """Accuracy factor, its limits and sensitivities, and sweeps of it.

    \b
    afmcalc accuracy --sweep C
    afmcalc accuracy clutch.toml --sweep C=0:1.25:6 --sweep z=4,8,12 --format csv
    afmcalc accuracy clutch.toml --sweep C --columns closing_force,torque_at_f_max
    afmcalc accuracy clutch.toml --sweep friction.max=0.4:0.8:9 --json
    """
    if columns and not sweep:
        raise AfmcalcError("--columns are those of a sweep: give --sweep NAME with them")
    clutch = common.clutch(spec)
    names = [name.strip() for text in columns or () for name in text.split(",")]
    common.calculate(clutch, sweeps=axes_of(sweep, clutch), columns=names)


def adjust(common: Common, spec: SpecArgument = None) -> None:
    """Both ways of setting the spring, at f_min and at mean friction.

    \b
    afmcalc adjust clutch.toml
    afmcalc adjust clutch.toml --set beta=1.1 --json
    """
    common.calculate(common.clutch(spec))


def overload(common: Common, spec: SpecArgument = None, sweep: SweepOption = None) -> None:
    """Torque at which a clutch with a torque margin trips: potential, expected, actuation (S22).

    \b
    afmcalc overload clutch.toml
    afmcalc overload clutch.toml --sweep zC=0.5:6:23
    afmcalc overload clutch.toml --sweep z1 --format csv
    """
    clutch = common.clutch(spec)
    common.calculate(clutch, sweeps=axes_of(sweep, clutch))


def life(
    common: Common,
    spec: SpecArgument = None,
    model: Annotated[
        StressRule, Option(help="Rule for the damaging stress: the paper's, Serensen-Kinasoshvili, Goodman.")
    ] = "mean-stress",
    sweep: SweepOption = None,
) -> None:
    """Cycles to failure on both sides of the clutch (S19).

    --sweep also takes dT, the scatter band at the T_min of the spec. The unprotected side takes drive.dynamic_factor,
    else the factor of the event, simulated at every point of a sweep, or once if dT or a key of [fatigue] is swept.

    \b
    afmcalc life clutch.toml
    afmcalc life clutch.toml --model amplitude --set fatigue.mean_stress_sensitivity=0.1
    afmcalc life clutch.toml --sweep dT=500:1100:13
    """
    clutch = common.clutch(spec)
    common.calculate(clutch, model=model, sweeps=axes_of(sweep, clutch, band=True))


def compare(
    common: Common,
    specs: Annotated[list[str] | None, Argument(metavar="SPEC", help="Specs to set side by side.")] = None,
    variants: Annotated[bool, Option("--variants", help="One clutch built as each possible variant.")] = False,
) -> None:
    """Clutches side by side, or one clutch as each variant.

    \b
    afmcalc compare a.toml b.toml
    afmcalc compare clutch.toml --variants
    """
    sources: list[str | None] = [*specs] if specs else [None]
    common.keep(*sources)
    clutches = [common.build(source) for source in sources]
    result, findings = common.ask(clutches, variants=variants)
    common.emit(result, findings, clutches[0].spec)


def axes_of(sweep: list[str] | None, clutch: "Clutch", *, band: bool = False) -> "list[Axis]":
    """Axes of ``--sweep``; with ``band`` an axis may also be dT, the scatter band."""
    if not sweep:
        return []
    from ..analysis.fatigue import parse_axes

    return parse_axes(sweep, clutch, band=band)


def frictions(texts: list[str] | None) -> "list[Pair]":
    """Frictions f_1 and f_2 in texts ``F`` or ``F1,F2``; f_2 is None if a text has one friction for all pairs."""
    points: list[Pair] = []
    for text in texts or ():
        try:
            values: list[Any] = [float(part) for part in text.split(",")]
            first, second = values if len(values) > 1 else (*values, None)
        except ValueError:
            values = []
        if not all(0 <= value < float("inf") for value in values or [-1]):
            raise AfmcalcError(
                "--friction {text:.80}: write a coefficient such as 0.3, or F1,F2 for unlike materials", text=text
            )
        points.append((first, second))
    return points
