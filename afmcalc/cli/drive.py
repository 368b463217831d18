"""Commands about the drive around a clutch: its events, what a trip does to the parts, and the springs."""

from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from ..analysis.registry import SpringKind, SpringOrder
from ..errors import AfmcalcError
from ..messages import say
from .clutch import FrictionOption, SweepOption, axes_of, friction_of
from .files import write
from .options import Common, SpecArgument, with_common

if TYPE_CHECKING:
    from ..analysis.torque import Pair
    from ..engines import Clutch
    from ..spec import Spec

HistoryOption = Annotated[
    str | None,
    Option("--history", metavar="FILE", help="Write torques, speeds and travel over time to FILE (CSV, SI)."),
]


@with_common
def simulate(
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    sweep: SweepOption = None,
    history: HistoryOption = None,
    *,
    common: Common,
) -> None:
    """The drive in time: what happens when the clutch trips, by the [drive] block.

    --output FILE writes the spec with the dynamic factor found, for life; the result goes to standard output all the
    same. With --friction the history is that of these frictions alone.

    An event is followed until nothing more can come, or for drive.event.duration. The time to a cut-off runs from the
    first slip on, also while the clutch is stuck again. A load resists as friction does and holds a stopped tool; that
    of a hoist would turn it back. The sleeve of an indirect clutch meets its stop elastically.

    \b
    afmcalc simulate drive.toml
    afmcalc simulate drive.toml --friction 0.2 --history event.csv
    afmcalc simulate drive.toml --sweep drive.shaft_stiffness
    afmcalc simulate drive.toml --output drive-with-factor.toml
    """  # noqa: D301
    from ..analysis.simulate import with_dynamic_factor

    if "-" in (common.output, history):
        raise AfmcalcError("simulate --output and --history write files beside the result: name one for each")
    common.keep(spec, beside=history, spec=True)
    printed = common.to_standard_output()
    points = [friction_of(text) for text in friction or ()]
    clutch = printed.clutch(spec)
    result = printed.calculate(clutch, friction=points, sweeps=axes_of(sweep, clutch)).result
    if history:
        _write_history(clutch, points, history, common)
    if common.output:
        about = say("Its dynamic factor is that of afmcalc simulate.")
        wrote = say("wrote the spec with the dynamic factor to {output}", output=common.output)
        common.write_spec(with_dynamic_factor(clutch.spec, result), about, wrote)


def _write_history(clutch: "Clutch", points: "list[Pair]", path: str, common: Common) -> None:
    from .. import __version__
    from ..analysis.simulate import history
    from ..render import renderer
    from ..result import Output

    with common.bar():
        output = Output(command="history", version=__version__, spec=None, result=history(clutch, points), findings=[])
    write(renderer(common.csv_dialect)(output, False), path, force=common.force)
    common.wrote(say("wrote the history to {output}", output=path))


@with_common
def heat(spec: SpecArgument = None, *, common: Common) -> None:
    """Work, temperature and wear of a trip, and how often the clutch may trip.

    \b
    afmcalc heat clutch.toml
    afmcalc heat clutch.toml --set drive.speed='1430 rpm' --set drive.cut_off='0.5 s'
    afmcalc heat clutch.toml --json
    """  # noqa: D301
    common.calculate(common.clutch(spec))


@with_common
def effects(spec: SpecArgument = None, *, common: Common) -> None:
    """What the torque law neglects, in numbers: splines, centrifugal force, wear.

    \b
    afmcalc effects clutch.toml
    afmcalc effects clutch.toml --set friction_group.spline_friction=0.15 --json
    """  # noqa: D301
    common.calculate(common.clutch(spec))


@with_common
def layout(spec: SpecArgument = None, *, common: Common) -> None:
    """Parts in half section: do they fit, mass, inertia ([envelope]).

    The parts lie as the papers draw them. Clearances, thrust bearings, keys, splines and bolts are not counted.

    \b
    afmcalc layout clutch.toml
    afmcalc layout clutch.toml --set envelope.length='200 mm' --json
    """  # noqa: D301
    common.calculate(common.clutch(spec))


@with_common
def springs(
    spec: SpecArgument = None,
    sort: Annotated[
        SpringOrder | None,
        Option(help="What is to be small.  [default: length where a stiffness is wanted, else wear]"),
    ] = None,
    top: Annotated[int, Option(min=1, max=1000, help="How many to tell of each spring.")] = 10,
    kind: Annotated[SpringKind, Option(help="Disc springs, coil springs, or both.")] = "any",
    tolerance: Annotated[
        float, Option(min=0, max=10, help="How far the stiffness may be off, as a share of it.")
    ] = 0.1,
    pick: Annotated[
        list[int] | None,
        Option(metavar="N", help="Take this one, one for each spring; --save writes the spec with it."),
    ] = None,
    save: Annotated[
        str | None, Option(metavar="FILE", help="Write the spec with the springs picked, comments and units kept.")
    ] = None,
    *,
    common: Common,
) -> None:
    """Disc stacks and coil springs that give the forces and stiffnesses of a clutch, within the room there is.

    What [closing_spring.room] and [control_spring.room] leave open is what the parts within [envelope] leave. With
    --save the spec with the springs is checked; the keys changed and the verdict are told.

    \b
    afmcalc springs clutch.toml --sort wear --kind disc
    afmcalc springs clutch.toml --set closing_spring.room.outer_diameter='120 mm' --top 20
    afmcalc springs clutch.toml --pick 3 --save sprung.toml
    afmcalc springs clutch.toml --pick 3 --json | afmcalc check -
    """  # noqa: D301
    if save and not pick:
        raise AfmcalcError("--save writes the spec with the springs of --pick: give both")
    if not pick:
        common.calculate(common.clutch(spec), sort=sort, top=top, kind=kind, tolerance=tolerance)
        return
    from ..analysis.springs import picked
    from ..spec import resolved

    common.keep(spec, beside=save)
    clutch = common.build(spec)
    result, findings = common.ask(clutch, sort, top, kind, tolerance)
    changes, sprung = picked(clutch, result, pick)
    common.emit(result, findings, resolved(sprung))
    if save:
        _save_sprung(clutch.spec, changes, sprung, save, common)


def _save_sprung(spec: "Spec", changes: dict[str, Any], sprung: "Spec", path: str, common: Common) -> None:
    """Write a spec with its springs, and tell what changed and what a check of it says."""
    from ..analysis.check import check
    from ..engines import build
    from ..spec.edit import value_at

    common.save_spec(spec, changes, sprung, path)
    for key, value in changes.items():
        if value != (before := value_at(spec, key)):
            common.note(say("{key}: {before} → {value}", key=key, before=_shown(before, key), value=_shown(value, key)))
    with common.bar():
        verdict = check(build(sprung))[0].verdict
    common.note(verdict.sentence)


def _shown(value: Any, key: str) -> str:
    """Return a value of a spec as a file has it, on one line."""
    from ..spec.saved import in_units

    if value is None:
        return "–"
    told = in_units(value.model_dump(exclude_none=True) if hasattr(value, "model_dump") else value, key)
    return ", ".join(f"{name} {each}" for name, each in told.items()) if isinstance(told, dict) else str(told)
