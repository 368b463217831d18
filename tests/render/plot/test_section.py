"""The section drawing measured from the numbers of its SVG, held against the spec, the layout and the checks."""

import itertools
import re
import sys
import tomllib
from xml.etree import ElementTree

import pytest
from conftest import CONFIGS, WANTED
from hypothesis import given, settings
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from strategies import direct_specs, indirect_specs, spaced_specs

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.figures import Request, gathered
from afmcalc.analysis.layout import layout
from afmcalc.engines import build
from afmcalc.engines.layout import TOUCHES
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.render.drawing import outlines
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.paint import WIDTH
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

CLUTCHES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
SLEEVES = ({"thrust disc", "pressure disc"}, {"ball sleeve", "thrust sleeve"})
"""Parts with pockets, of a direct and of an indirect clutch."""
NUMBER = re.compile(r"-?[\d.]+")


def gathered_of(clutch):
    return gathered("section", Request([Answers(clutch)]))


def sheet(clutch):
    return sheet_of("section", gathered_of(clutch))


def svg(clutch):
    return ElementTree.fromstring(sheet(clutch).panels[0].svg("title"))


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
    """Whether a point is within any of the shapes: to the right of it an odd number of edges is crossed."""
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
    """Middles of all cells between the edges of parts, but for those that rounding makes."""
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
    return {frozenset(str(text).partition(" overlap by ")[0].split(" and ")) for text in texts}


@pytest.mark.parametrize("lang", [None, "ru"])
def test_dimensions_are_those_of_the_spec(lang):
    clutch = build(read_spec("example:envelope"))
    given = tomllib.loads((CONFIGS / "envelope.toml").read_text(encoding="utf-8"))
    mm = {f"{block}.{key}": float(value.split()[0]) for block, keys in given.items() if isinstance(keys, dict)
          for key, value in keys.items() if isinstance(value, str) and value.endswith(" mm")}  # fmt: skip
    with speaking(language(lang) if lang else ENGLISH):
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


@settings(max_examples=50)
@given(spaced_specs())
def test_parts_overlap_as_check_reports(spec):
    clutch = build(spec)
    section, drawing = gathered_of(clutch), svg(clutch)
    reported = colliding(Answers(clutch).ask("check")[1])
    assert overlapping(drawing) == reported
    assert {frozenset(pair) for *pair, _ in section.overlaps} == reported
    assert {
        frozenset(name.split("/")) for shape in drawing.iter() if "/" in (name := shape.get("data-part", ""))
    } == reported
    result, _ = layout(clutch)
    assert {name: part.row for name, part in section.parts.items()} == {row.part: row for row in result.parts}
    assert measured(drawing)["length"] == pytest.approx(result.length * 1e3, abs=2e-4)
    # only a bore that is not given may be missing, and it means none
    assert not section.assumed.keys() - {"control_unit.face_gap"}


@given(direct_specs())
def test_what_is_filled_in_gives_the_layout_that_is_drawn(spec):
    """The spec with the keys told lays out the same parts; only springs are no parts of it yet."""
    section = gathered_of(build(spec))
    whole = {path: value for path, value in section.assumed.items() if not path.startswith("closing_spring")}
    if "friction_group.inner_radius" in whole:
        assert whole["friction_group.inner_radius"] + whole["friction_group.outer_radius"] == pytest.approx(
            2 * spec.friction_group.mean_radius
        )
        whole["friction_group.mean_radius"] = None
    result, findings = layout(build(respecified(spec, whole)))
    spring = frozenset(("closing spring",))
    assert {frozenset(pair) for *pair, _ in section.overlaps if not spring & {*pair}} == colliding(findings)
    for row in result.parts:
        if row.part not in ("housing", "hub"):  # as long as the spring has it
            assert section.parts[row.part].row.model_dump() == pytest.approx(row.model_dump())


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
    counts = {}
    for name in ("default", "all-driving", "conventional", "envelope"):
        groups = {group.get("class"): group for group in svg(build(read_spec(f"example:{name}"))).iter(named("g"))}
        layers = ("bypass", "discs", "ghost", "balls", "assumed")
        counts[name] = [len(groups[layer]) if layer in groups else 0 for layer in layers]
        parts = {part for part in gathered_of(build(read_spec(f"example:{name}"))).parts if "spring" in part}
        assert parts == ({"closing spring", "control spring"} if name == "envelope" else {"closing spring"})
    assert counts["default"][:3] == [2, 14, 0]  # one pair of eight, above and below the axis
    assert counts["all-driving"][:3] == [0, 8, 0]
    assert counts["conventional"][:3] == [0, 16, 0]
    assert counts["envelope"][3] == 2 + 6
    assert counts["envelope"][2] > 0
    assert counts["envelope"][4] == 1  # the key
    assert not [*gathered_of(build(read_spec("example:conventional"))).parts.keys() & {"balls"}]


@pytest.mark.every(5)
@pytest.mark.parametrize("lang", [None, "ru"])
@pytest.mark.parametrize("name", CLUTCHES)
def test_no_text_covers_another_or_overruns(name, lang):
    with speaking(language(lang) if lang else ENGLISH):
        drawing = sheet(build(read_spec(f"example:{name}"))).panels[0]
        figure = Figure(figsize=(WIDTH, drawing.height), dpi=100)
        FigureCanvasAgg(figure)
        axes = figure.add_axes((0, 0, 1, 1))
        drawing.paint(axes)
        figure.canvas.draw()
        boxes = [(text.get_text(), text.get_window_extent()) for text in axes.texts]
    assert {text.get_fontsize() for text in axes.texts} == {9.0}
    for text, box in boxes:
        assert 0 <= box.x0 < box.x1 <= figure.bbox.x1, text
        assert 0 <= box.y0 < box.y1 <= figure.bbox.y1, text
    for (one, box), (other, beside) in itertools.combinations(boxes, 2):
        wide = min(box.x1, beside.x1) - max(box.x0, beside.x0)
        high = min(box.y1, beside.y1) - max(box.y0, beside.y0)
        assert min(wide, high) <= 1, (one, other)


def test_an_svg_needs_no_library(afmcalc, tmp_path, monkeypatch):
    for module in ("matplotlib", "matplotlib.figure", "matplotlib.patches"):
        monkeypatch.setitem(sys.modules, module, None)
    target = tmp_path / "s.svg"
    name = "<script>alert(1)</script> a_b"
    assert afmcalc("plot", "section", "--set", f"name={name}", "-o", target).code == 0
    texts = ["".join(text.itertext()) for text in ElementTree.parse(target).iter(named("text"))]
    assert "<script>alert(1)</script> a_b" in texts
    run = afmcalc("plot", "section", "-o", tmp_path / "s.png")
    assert (run.code, "afmcalc[plot]" in run.err) == (2, True)


def test_the_same_spec_gives_the_same_bytes(afmcalc, tmp_path):
    files = [tmp_path / name for name in ("a.svg", "b.svg")]
    assert [afmcalc("plot", "section", "example:indirect", "-o", file).code for file in files] == [0, 0]
    assert files[0].read_bytes() == files[1].read_bytes()


def test_a_sketch_is_to_scale(afmcalc):
    out = afmcalc("plot", "section", "example:envelope").out
    frame = [
        line.partition("│")[2] or line.partition("┤")[2] for line in out.splitlines() if "│" in line or "┤" in line
    ]
    letters = [line for line in frame if "1" in line or "2" in line]
    wide, high = max(map(len, letters)), len(frame)
    assert wide / (2 * high) == pytest.approx(110.38 / 126, rel=0.08)
    assert "9.6533" in out
    assert max(map(len, out.splitlines())) <= 80


def test_outlines():
    step = outlines([(0, 2, 0, 1), (1, 3, 1, 2)])
    assert step == (((0, 0), (2, 0), (2, 1), (3, 1), (3, 2), (1, 2), (1, 1), (0, 1)),)
    hole = outlines([(0, 3, 0, 1), (0, 3, 2, 3), (0, 1, 0, 3), (2, 3, 0, 3)])
    assert {frozenset(ring) for ring in hole} == {
        frozenset([(0, 0), (3, 0), (3, 3), (0, 3)]), frozenset([(1, 1), (1, 2), (2, 2), (2, 1)])
    }  # fmt: skip
    assert len(outlines([(0, 1, 0, 1), (1, 2, 1, 2)])) in (1, 2)
    assert outlines([]) == ()
