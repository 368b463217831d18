"""Commands about parts and drive: pockets and balls, springs, layout, the trip of the clutch, neglected effects."""

from typing import TYPE_CHECKING, Annotated

from typer import Option

from ..analysis.registry import SpringKind, SpringOrder
from ..errors import AfmcalcError, need
from ..messages import say
from .clutch import FrictionOption, SweepOption, axes_of, frictions
from .files import ending_of, is_drawing, picture_of, refuse, write
from .options import Common, SaveOption, SpecArgument

if TYPE_CHECKING:
    from ..engines import Clutch


def pocket(common: Common, spec: SpecArgument = None, save: SaveOption = None) -> None:
    """Wall angle, balls and pockets of the control unit; -o FILE.dxf or .svg draws them for the shop.

    \b
    afmcalc pocket clutch.toml
    afmcalc pocket clutch.toml -o pocket.dxf
    afmcalc pocket clutch.toml --save completed.toml
    afmcalc pocket clutch.toml --json | afmcalc torque -
    """
    from ..analysis.synthesize import completed

    clutch, drawing = _clutch(common, spec, "svg", "dxf", save=save)
    if drawing:
        _draw(clutch, drawing, common)
    result = common.ask(clutch)[0] if drawing else common.calculate(clutch)
    if save:
        common.save_spec(clutch.spec, completed(result), save)


def _clutch(common: Common, spec: str | None, *kinds: str, save: str | None = None) -> "tuple[Clutch, str | None]":
    """Clutch of a spec, and the format of the drawing if the file of --output is a drawing, else None."""
    if not is_drawing(common.output):
        return common.clutch(spec, save=save), None
    drawing = picture_of(common.output, *kinds)
    refuse(common.output, save, force=common.force, inputs=[spec])
    if extra := {"dxf": "cad", "pdf": "pdf"}.get(drawing):
        need(extra)
    return common.drawn(spec), drawing


def _draw(clutch: "Clutch", kind: str, common: Common) -> None:
    """Write a drawing to scale: the pockets for the shop in true millimetres, or the section with the part list."""
    from ..analysis.asking import Answers
    from ..analysis.plot_data import Request, gathered
    from ..render import shop_sheet
    from ..render.dxf import dxf
    from ..render.svg import svg

    request = Request([Answers(clutch)])
    with common.bar():
        if common.command == "pocket":
            drawing = shop_sheet.pocket(gathered("pocket", request))
            content = dxf(drawing) if kind == "dxf" else svg(drawing).encode()
        elif kind == "dxf":
            content = dxf(shop_sheet.section(gathered("section", request), clutch.spec))
        else:
            from ..render.plot import sheet_of
            from ..render.plot.figure import save

            content = save(sheet_of("section", gathered("section", request)), kind)
    common.save(content, common.output)


def layout(common: Common, spec: SpecArgument = None) -> None:
    """Parts in half section: do they fit, mass, inertia ([envelope]); -o FILE.svg, .dxf or .pdf draws them.

    The parts lie as the papers draw them. Clearances, thrust bearings, keys, splines and bolts are not counted.

    \b
    afmcalc layout clutch.toml
    afmcalc layout clutch.toml -o section.svg
    afmcalc layout clutch.toml --set envelope.length='200 mm' --json
    """
    clutch, drawing = _clutch(common, spec, "svg", "dxf", "pdf")
    if drawing:
        _draw(clutch, drawing, common)
    else:
        common.calculate(clutch)


def springs(
    common: Common,
    spec: SpecArgument = None,
    sort: Annotated[
        SpringOrder | None,
        Option(help="Quantity to minimise.  [default: length if a stiffness is wanted, else wear]"),
    ] = None,
    top: Annotated[int, Option(min=1, max=1000, help="How many candidates to list per spring.")] = 10,
    kind: Annotated[SpringKind, Option(help="Disc springs, coil springs, or both.")] = "any",
    tolerance: Annotated[float, Option(min=0, max=10, help="Allowed relative deviation of the stiffness.")] = 0.1,
    pick: Annotated[
        list[int] | None,
        Option(metavar="N", help="Take candidate N; repeat for the other spring. --save writes the spec."),
    ] = None,
    save: SaveOption = None,
) -> None:
    """Disc stacks and coil springs that give the forces and stiffnesses of a clutch, within the room there is.

    Room that [closing_spring.room] or [control_spring.room] does not give is what the parts in [envelope] leave.
    With --save the new spec is also checked, and the verdict printed.

    \b
    afmcalc springs clutch.toml --sort wear --kind disc
    afmcalc springs clutch.toml --set closing_spring.room.outer_diameter='120 mm' --top 20
    afmcalc springs clutch.toml --pick 3 --save sprung.toml
    afmcalc springs clutch.toml --pick 3 --json | afmcalc check -
    """
    if save and not pick:
        raise AfmcalcError("--save writes the spec with the springs of --pick: give both")
    if not pick:
        common.calculate(common.clutch(spec), sort=sort, top=top, kind=kind, tolerance=tolerance)
        return
    from ..analysis.spring_search import picked

    clutch = common.clutch(spec, save=save)
    result, findings = common.ask(clutch, sort, top, kind, tolerance)
    changes, sprung = picked(clutch, result, pick)
    common.emit(result, findings, sprung)
    if save:
        from ..analysis.check import check
        from ..engines import build
        from ..spec.edit import value_at

        common.save_spec(clutch.spec, changes, save, sprung)
        for key, value in changes.items():
            if value != (before := value_at(clutch.spec, key)):
                before, after = (_written(one, key) for one in (before, value))
                common.note(say("{key}: {before} → {value}", key=key, before=before, value=after))
        with common.bar():
            verdict = check(build(sprung))[0].verdict
        common.note(verdict.sentence)


def _written(value: object, key: str) -> str:
    """Text of a key's value, or of each key of a table, in units as in a file; a dash for None."""
    from ..spec.edit import in_units

    if value is None:
        return "–"
    shown = in_units(value, key)
    return ", ".join(f"{name} = {each}" for name, each in shown.items()) if isinstance(shown, dict) else str(shown)


def simulate(
    common: Common,
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    sweep: SweepOption = None,
    history: Annotated[
        str | None, Option(metavar="FILE", help="Write torques, speeds and travel over time to FILE (CSV, SI).")
    ] = None,
    save: SaveOption = None,
) -> None:
    """Simulate the drive of [drive] over time as the clutch trips, with the heat.

    Without [drive.event] only the heat is calculated. --save writes the spec with the dynamic factor found, for life.
    With --friction the history holds these frictions only.

    An event is simulated until no further slip or higher peak is possible, or for drive.event.duration. The time to
    a cut-off counts from the first slip, also while the clutch sticks again. A load only resists: it holds a stopped
    tool, whereas a hoist's load would turn it back. The stop of the sleeve of an indirect clutch is rigid.

    \b
    afmcalc simulate drive.toml
    afmcalc simulate drive.toml --friction 0.2 --history event.csv
    afmcalc simulate drive.toml --sweep drive.shaft_stiffness
    afmcalc simulate drive.toml --save drive-with-factor.toml
    """
    if history == "-":
        raise AfmcalcError("--history writes a file beside the result: name one")
    points = frictions(friction)
    clutch = common.clutch(spec, beside=history, save=save)
    if history:
        ending_of("--history", history, ".csv", ".txt", others=True)
    if clutch.spec.drive.event is None:
        for option, given in {"--friction": points, "--sweep": sweep, "--history": history, "--save": save}.items():
            if given:
                raise AfmcalcError("{option} is of an event: give [drive.event]", option=option)
        common.command = "heat"
        common.calculate(clutch)
        return
    result = common.calculate(clutch, friction=points, sweeps=axes_of(sweep, clutch), heated=not sweep)
    if history:
        from .. import __version__
        from ..analysis.simulate import history as moments
        from ..render import renderer
        from ..result import Output

        with common.bar():
            output = Output("history", __version__, None, moments(clutch, points), [])
        write(renderer("csv")(output, False), history, force=common.force)
        common.note(say("wrote the history to {output}", output=history))
    if save:
        common.save_spec(clutch.spec, {"drive.dynamic_factor": result.largest_dynamic_factor}, save)


def effects(common: Common, spec: SpecArgument = None) -> None:
    """Effects that the torque law neglects, in numbers: centrifugal force, wear, friction of the parts.

    \b
    afmcalc effects clutch.toml
    afmcalc effects clutch.toml --set friction_group.spline_friction=0.15 --json
    """
    common.calculate(common.clutch(spec))
