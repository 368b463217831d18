"""Strip of results: the main numbers of a clutch, each with the grade of its checks and the pinned number."""

from collections import namedtuple
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

from ..analysis.asking import Answers
from ..analysis.check import CheckResult, CheckRow, lacks, told
from ..analysis.compare import change
from ..engines.checks import REQUIRED
from ..messages import deferred, localized, percent, say, translate, with_unit
from ..render.amounts import display, display_unit

_About = namedtuple("_About", "name symbol unit quantities rows needs judged", defaults=(None, None))
"""Contents of a tile; ``rows``: the checks that grade the tile, by code or, for requirements, by name of the key."""
_TILES = (
    _About(deferred("trip torque"), "T_min…T_max", "N*m", "torque_min torque_max",
        "below-nominal-torque returning-below-nominal machine-not-driven machine.power nominal_torque machine_torque "
        "torque_max trip_ratio.min trip_ratio.max"),
    _About(deferred("accuracy factor"), "K_т", "1", "accuracy_factor",
        "accuracy-not-lasting gain-above-limit reduced-gain-above-limit feedback-idle accuracy_factor "
        "accuracy_factor_hysteresis reduced_gain"),
    _About(deferred("surface pressure in the mean"), "p", "Pa", "mean_pressure",
        "mean-pressure-in-range mean-pressure-exceeded peak-pressure-in-range peak-pressure-exceeded "
        "contact-force-exceeded event-contact-force surface_pressure contact_pressure", None, "surface_pressure"),
    _About(deferred("temperature of the faces, or of the discs"), "Θ", "K abs", "hottest",
        "temperature-in-range temperature-exceeded temperature face_temperature", "heat", "temperature"),
    _About(deferred("peak torque in the shaft"), "T_peak", "N*m", "peak_torque",
        "peak_torque", "simulate", "peak_torque"),
    _About(deferred("diameter and length of the clutch"), "D × L", "m", "outer_diameter length",
        "housing-too-wide clutch-too-long", "layout"),
)  # fmt: skip
_GRADES = ("fail", "not judged", "warning", "note", "pass")

Tile = namedtuple("Tile", "name symbol waits value unit note grade pinned change", defaults=("–", "", "", "", "", ""))
"""A tile; ``waits``: its value is still being calculated; ``change``: difference from the pinned value, if any."""


def values(answers: Answers, without: Collection[str]) -> dict[str, list[Any]]:
    """Symbol → numbers of each tile; tiles whose analysis is in ``without`` are left out."""
    return {
        about.symbol: [told(answers, about.needs).get(name) for name in about.quantities.split()]
        for about in _TILES
        if about.needs not in without
    }


def tiles(
    answers: Answers, checked: CheckResult, without: Collection[str], pinned: Mapping[str, list[Any]]
) -> Iterator[Tile]:
    """Yield the tiles of a clutch, each with the number of the pinned clutch."""
    known = values(answers, without)
    for about in _TILES:
        now, before = known.get(about.symbol), pinned.get(about.symbol)
        tile = Tile(translate(about.name), about.symbol, waits=now is None)
        if now and now[-1] is not None:
            own = {*about.rows.split()}
            rows = [row for row in checked.checks if own & {row.code, (row.path or "").removeprefix("requirements.")}]
            remarks = answers.ask("layout")[1] if about.needs == "layout" else []
            missing = next((each.message for each in remarks if each.code == "layout-without"), "")
            tile = tile._replace(
                value=_shown(about, now), unit="" if about.unit == "1" else display_unit(about.unit),
                note=missing or _note(about, checked, rows),
                grade=min((row.grade for row in rows), key=_GRADES.index, default=""),
            )  # fmt: skip
        elif now:
            lacking = lacks(answers.quiet, REQUIRED[about.judged]) if about.judged else "[envelope]"
            tile = tile._replace(note=say("needs {needs}", needs=lacking))
        if before and (was := _shown(about, before)) not in (tile.value, "–"):
            tile = tile._replace(pinned=was, change=_change(about, now and now[-1], before[-1]))
        yield tile


def _shown(about: _About, numbers: Sequence[Any]) -> str:
    sign = " × " if about.symbol == "D × L" else "…"
    return "–" if numbers[-1] is None else sign.join(display(each, about.unit, 4) for each in numbers)


def _change(about: _About, now: Any, before: Any) -> str:
    """Change of the last number of a tile: for a temperature in kelvins, for other quantities as a share."""
    if about.unit == "K abs" and now is not None:
        return with_unit(localized(f"{now - before:+.3g}"), translate("K", "unit"))
    share = change(now, before)
    return "" if share is None else localized(f"{share:+.1%}")


def _note(about: _About, checked: CheckResult, rows: Sequence[CheckRow]) -> str:
    """Note of a tile: multiples of the rated torque, else the check that is nearest to its limit or farthest beyond."""
    low, high = checked.trip_ratio_min, checked.trip_ratio_max
    if about.symbol == "T_min…T_max" and low is not None:
        return say("{low}…{high} × rated", low=display(low, "1", 4), high=display(high, "1", 4))
    used = [(row.utilisation, row.name) for row in rows if row.utilisation is not None and row.level != "info"]
    if not used:
        return say("no limit")
    share, name = max(used)
    return f"{percent(share)}: {name}"
