"""The section drawing measured from the numbers of its SVG, held against the spec, the layout and the checks."""

import itertools
import re
import sys
import tomllib
from xml.etree import ElementTree

import pytest
from conftest import CONFIGS
from hypothesis import given
from strategies import indirect_specs, spaced_specs

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.half_section import layout
from afmcalc.analysis.plot_data import Request, gathered
from afmcalc.engines import build
from afmcalc.engines.rings import TOUCHES
from afmcalc.render.drawing import Inscription, Length, Region, Stroke, exploded
from afmcalc.render.plot import sheet_of
from afmcalc.render.svg import svg as written
from afmcalc.spec import read_spec

SLEEVES = ({"thrust disc", "pressure disc"}, {"ball sleeve", "thrust sleeve"})
"""Parts with pockets, of a direct and of an indirect clutch."""
NUMBER = re.compile(r"-?[\d.]+")


def gathered_of(clutch):
    return gathered("section", Request([Answers(clutch)]))


def sheet(clutch):
    return sheet_of("section", gathered_of(clutch))


def svg(clutch):
    return ElementTree.fromstring(written(sheet(clutch).panels[0], "title"))


def named(tag):
    return f"{{http://www.w3.org/2000/svg}}{tag}"


def numbers(path):
    """Points of a path, mm, y upwards."""
    values = [float(value) for value in NUMBER.findall(path)]
    return [(x, -y) for x, y in zip(values[::2], values[1::2], strict=True)]


def measured(drawing):
    """Key of each dimension → the length of its line, mm."""
    found = {}
    for group in drawing.iter(named("g")):
        if key := group.get("data-key"):
            (x, y), (far, high) = numbers(group.find(named("path")).get("d"))
            assert x == far or y == high
            found[key] = abs(far - x) + abs(high - y)
    return found


def drawn(drawing):
    """Name of each part → its contours above the axis, mm: a ball is the square around it, as the layout has it."""
    parts = {}
    for shape in drawing.iter():
        name = shape.get("data-part")
        if name is None or "/" in name:
            continue
        if shape.tag == named("circle"):
            x, y, r = float(shape.get("cx")), -float(shape.get("cy")), float(shape.get("r"))
            contours = [[(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)]]
        else:
            contours = [numbers(contour) for contour in shape.get("d").split("Z") if contour]
        if max(y for contour in contours for _, y in contour) > 1e-3:
            parts.setdefault(name, []).append(contours)
    return parts


def covers(shapes, x, y):
    """True if a point is within any of the shapes: to the right of it an odd number of edges is crossed."""
    return any(
        sum(
            (a[1] > y) != (b[1] > y) and a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) > x
            for contour in contours
            for a, b in zip(contour, [*contour[1:], contour[0]], strict=True)
        )
        % 2
        for contours in shapes
    )


def cells(*parts):
    """Yield the middles of all cells between the edges of parts, except cells that are only rounding errors."""
    points = [point for shapes in parts for contours in shapes for contour in contours for point in contour]
    sides = (sorted({point[side] for point in points}) for side in (0, 1))
    middles = ([(a + b) / 2 for a, b in itertools.pairwise(side) if b - a > 3e-4] for side in sides)
    return itertools.product(*middles)


def overlapping(drawing):
    parts = drawn(drawing)
    pockets = SLEEVES["stop ring" in parts or "control spring" in parts]
    return {
        frozenset((one, other))
        for one, other in itertools.combinations(parts, 2)
        if not ("balls" in (one, other) and pockets & {one, other})
        and any(covers(parts[one], x, y) and covers(parts[other], x, y) for x, y in cells(parts[one], parts[other]))
    }


def colliding(findings):
    texts = (finding.message for finding in findings if finding.code == "parts-collide")
    return {frozenset(str(text).partition(" are in each other's way by ")[0].split(" and ")) for text in texts}


def test_dimensions_are_those_of_the_spec():
    clutch = build(read_spec("example:envelope"))
    given = tomllib.loads((CONFIGS / "envelope.toml").read_text(encoding="utf-8"))
    mm = {f"{block}.{key}": float(value.split()[0]) for block, keys in given.items() if isinstance(keys, dict)
          for key, value in keys.items() if isinstance(value, str) and value.endswith(" mm")}  # fmt: skip
    found = measured(svg(clutch))
    laid_out, _ = layout(clutch)
    springs = {part.part: (part.right - part.left) * 1e3 for part in laid_out.parts if part.part.endswith("spring")}
    assert found == pytest.approx(
        {
            "inner_diameter": 2 * mm["friction_group.inner_radius"],
            "outer_diameter": 2 * mm["friction_group.outer_radius"],
            "housing": 2 * (mm["friction_group.outer_radius"] + mm["envelope.housing_wall"]),
            "ball_circle": 2 * mm["control_unit.ball_circle_radius"],
            "hub": mm["control_unit.hub_diameter"],
            "bore": mm["envelope.bore"],
            "face_gap": mm["control_unit.face_gap"],
            "length": laid_out.length * 1e3,
            "travel": float(clutch.travel_max) * 1e3,
            "closing_length": springs["closing spring"],
            "control_length": springs["control spring"],
        },
        abs=2e-4,
    )


@given(spaced_specs())
def test_parts_overlap_as_check_reports(spec):
    clutch = build(spec)
    section, drawing = gathered_of(clutch), svg(clutch)
    reported = colliding(Answers(clutch).ask("check")[1])
    assert {frozenset(pair) for *pair, _ in section.overlaps} == reported
    shown = (shape.get("data-part", "") for shape in drawing.iter())
    marked = {frozenset(name.split("/")) for name in shown if "/" in name}
    assert overlapping(drawing) <= marked <= reported, "what lies outside the housing or on the shaft is reported too"
    result, _ = layout(clutch)
    assert {name: part.row for name, part in section.parts.items()} == {row.part: row for row in result.parts}
    assert measured(drawing)["length"] == pytest.approx(result.length * 1e3, abs=2e-4)
    # only the dimension of the bore may be missing, if the spec gives no bore
    assert not section.assumed.keys() - {"control_unit.face_gap"}


def test_defaults_do_not_collide():
    """Balls that overlap an assumed hub are no collision; without an envelope ``check`` reports none either."""
    clutch = build(read_spec("example:default", ["control_unit.ball_circle_radius=20 mm"]))
    assert overlapping(svg(clutch)) == {frozenset(("hub", "balls")), frozenset(("thrust disc", "pressure disc"))}
    assert gathered_of(clutch).overlaps == [] == [*colliding(Answers(clutch).ask("check")[1])]


@given(indirect_specs(curved=True))
def test_what_moves_is_ghosted_by_the_travel(spec):
    clutch = build(spec)
    section = gathered_of(clutch)
    assert section.travel == float(clutch.travel_max)
    moved = {name: part for name, part in section.parts.items() if part.moved}
    if section.travel > TOUCHES:
        moving = {"thrust sleeve": (1, 1), "closing spring": (0, 1), "control spring": (1, 0)}
        assert set(moved) - {"balls"} == section.parts.keys() & moving.keys() >= {"closing spring", "control spring"}
        for name, ends in ((name, moving[name]) for name in moved if name != "balls"):
            for box, after in zip(moved[name].boxes, moved[name].moved, strict=True):
                way = after.left - box.left, after.right - box.right
                assert way == pytest.approx([end * section.travel for end in ends], abs=1e-12)
    assert svg(clutch) is not None


def test_variants_differ():
    """Variants differ in the number of bypass discs, of all discs, of moved parts, balls and assumed parts drawn."""

    def counts(name):
        groups = {group.get("class"): group for group in svg(build(read_spec(f"example:{name}"))).iter(named("g"))}
        layers = ("bypass", "discs", "ghost", "balls", "assumed")
        return [len(groups[layer]) if layer in groups else 0 for layer in layers]

    assert counts("default")[:3] == [2, 14, 0]  # one bypass pair of eight, above and below the axis
    assert counts("all-driving")[:3] == [0, 8, 0]
    assert counts("conventional")[:4] == [0, 16, 0, 0]
    ghosts, balls, assumed = counts("envelope")[2:]
    assert (ghosts > 0, balls, assumed) == (True, 2 + 6, 1)  # the key


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize("long", [100.0, 2.5])
def test_a_dimension_has_arrows_between_its_ends_and_lines_to_them(long, upright):
    """If it is short the arrows stand outside; an extension line goes from each end beyond the dimension line."""
    turned = (lambda x, y: (y, x)) if upright else (lambda x, y: (x, y))
    line = Length("12.5", 4.0, turned(1.0, 2.0), turned(1.0 + long, 0.0), 9.0, upright)
    parts = [part for part in exploded(line) if not isinstance(part, Inscription)]
    heads = [[turned(*point) for point in part.contours[0]] for part in parts if isinstance(part, Region)]
    strokes = [[turned(*point) for point in part.points] for part in parts if isinstance(part, Stroke)]
    assert [tip for tip, *_ in heads] == [(1, 9), (1 + long, 9)]
    inward = 1 if long == 100 else -1
    for (tip, back, *_), way in zip(heads, (inward, -inward), strict=True):
        assert back[0] == pytest.approx(tip[0] + way * 2.2)
    assert [[(1, 9), (1 + long, 9)], [(1, 2), (1, 10)], [(1 + long, 0), (1 + long, 10)]] == [
        stroke for stroke in strokes if stroke[0][0] == stroke[1][0] or {x for x, _ in stroke} == {1, 1 + long}
    ]
    assert len(strokes) == (3 if long == 100 else 5)  # tails of the arrows that stand outside


def test_an_svg_needs_no_library(afmcalc, tmp_path, monkeypatch):
    for module in ("matplotlib", "matplotlib.figure", "matplotlib.patches"):
        monkeypatch.setitem(sys.modules, module, None)
    target = tmp_path / "s.svg"
    name = "<script>alert(1)</script> a_b"
    assert afmcalc("layout", "--set", f"name={name}", "-o", target).code == 0
    texts = ["".join(text.itertext()) for text in ElementTree.parse(target).iter(named("text"))]
    assert "<script>alert(1)</script> a_b" in texts
    run = afmcalc("layout", "-o", tmp_path / "s.pdf")
    assert (run.code, "afmcalc[pdf]" in run.err) == (2, True)
