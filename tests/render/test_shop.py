"""Drawings for the shop: the DXF read back, its contours held against the wall by distance; SVG alike."""

import functools
import io
import math
import re
import xml.etree.ElementTree as ElementTree

import ezdxf
import numpy as np
import pytest
from conftest import CONFIGS, overrides, slow
from sources import REFUSED

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.assembly import section
from afmcalc.analysis.pocket_contours import shop_drawing
from afmcalc.analysis.pocket_wall import wall_of
from afmcalc.analysis.synthesize import pocket as designed
from afmcalc.engines import build
from afmcalc.render.dxf import dxf
from afmcalc.render.shop_sheet import pocket
from afmcalc.render.svg import svg
from afmcalc.spec import read_spec

CLUTCHES = {"one": "constant-torque", "straight": "indirect", "direct": "default"}


@functools.cache
def made(kind):
    """Clutch, its control unit as synthesized, the drawing of its pocket, and that drawing as read from DXF."""
    clutch = build(read_spec(f"example:{CLUTCHES[kind]}"))
    found, _ = designed(clutch)
    drawing = shop_drawing(clutch, found)
    document = ezdxf.read(io.StringIO(dxf(pocket(drawing)).decode("utf-8")))
    assert not document.audit().has_issues
    return clutch, found, drawing, document


@pytest.fixture(params=["one", "straight", pytest.param("direct", marks=pytest.mark.slow)])
def drawn(request):
    return made(request.param)


def distances(points, wall, start, stop):
    """Distances of points from the wall, mm: those from the sampled path of the ball's centre, less the ball radius."""
    depth = np.linspace(start, stop, 20001)
    path = np.stack([depth, depth * wall.tangent + wall.steepening * depth**2 / 2]) * 1e3
    found = []
    for point in points:
        gaps = np.hypot(*(path - np.array(point)[:, None]))
        i = int(np.clip(np.argmin(gaps), 1, len(depth) - 2))
        # a parabola through three samples, so that sampling is not taken for an error of the drawing
        a, b, c = gaps[i - 1 : i + 2] ** 2
        found.append(math.sqrt(b - (c - a) ** 2 / (8 * (a - 2 * b + c))) - wall.ball_radius * 1e3)
    return np.array(found)


def test_the_contours_are_the_wall(drawn):
    clutch, found, drawing, document = drawn
    assert document.header["$INSUNITS"] == 4
    space = document.modelspace()
    assert {layer.dxf.name for layer in document.layers} >= {
        "SLEEVE_1",
        "SLEEVE_2",
        "POCKET_1",
        "POCKET_2",
        "PATH",
        "BALL",
        "DIMENSIONS",
    }
    (first,) = space.query('LWPOLYLINE[layer=="POCKET_1"]')
    closed = {line.dxf.layer for line in space.query("LWPOLYLINE") if line.closed}
    assert closed == {"SLEEVE_1", "SLEEVE_2", "POCKET_1", "POCKET_2", "FRAME", "TITLE"}
    assert all(len(whole(line)) > 1 for line in space.query("LWPOLYLINE"))
    assert {line.dxf.layer for line in space.query("LINE")} == {"HATCH"}
    own = wall_of(clutch, found.face_gap, found.ball_diameter / 2)
    points = np.array([point[:2] for point in first.get_points()])
    upper = points[points[:, 1] > 0]
    curve = upper[upper[:, 0] <= found.face_gap * 500 + found.pocket_depth_cut * 1e3 - 1e-9]
    touching = curve[curve[:, 0] <= -own.at(0.0).wall_axial * 1e3 + 1e-9]
    off = distances(touching * [-1, 1], own, 0.0, own.mouth + 1e-3)
    assert off == pytest.approx(0, abs=1e-9)
    between = (touching[1:] + touching[:-1]) / 2
    inside = distances(between * [-1, 1], own, 0.0, own.mouth + 1e-3)
    assert np.abs(inside).max() <= 1e-2
    assert points[:, 1] == pytest.approx(-points[::-1, 1], abs=1e-12), "both hands alike"
    assert np.ptp(points[:, 1]) == pytest.approx(found.pocket_width * 1e3, abs=1e-9)
    assert np.ptp(points[:, 0]) == pytest.approx((found.pocket_depth_cut + drawing.sleeve.relief) * 1e3, abs=1e-9)


def whole(contour):
    """Points of a polyline, with the first again at the end of a closed one; asserts that no neighbours coincide."""
    points = np.array([point[:2] for point in contour.get_points()])
    points = np.vstack([points, points[:1]]) if contour.closed else points
    assert np.hypot(*np.diff(points, axis=0).T).min() > 1e-6, contour.dxf.layer
    return points


@pytest.mark.parametrize("name", ["POCKET_1", "POCKET_2"])
def test_the_ball_touches_the_walls_and_not_the_floor(drawn, name):
    _, found, drawing, document = drawn
    (contour,) = document.modelspace().query(f'LWPOLYLINE[layer=="{name}"]')
    points, radius = whole(contour), found.ball_diameter * 500
    dense = np.concatenate([np.linspace(a, b, 1001) for a, b in zip(points[:-1], points[1:], strict=True)])
    deep = np.abs(dense[:, 0]) > found.face_gap * 500 + 1e-9
    off = np.hypot(*dense[deep].T) - radius
    assert off.min() == pytest.approx(0, abs=2e-3), "a chord, and samples"
    floor = np.abs(dense[deep][:, 0]) > radius - 1e-9
    assert off[floor].min() > 0
    bottom = np.abs(dense[deep][:, 0]).max()
    assert bottom - radius == pytest.approx(drawing.sleeve.relief * 1e3)
    assert 0.05 * 2 * radius <= bottom - radius < 0.05 * 2 * radius + 0.1
    touching = dense[deep][off < 5e-3]
    steep = np.abs(touching[:, 0]) / radius
    assert steep == pytest.approx(math.sin(found.wall_angle), abs=0.05), "where the walls are normal to the ball"


def test_dimensions_are_those_of_the_spec(drawn):
    """Dimensions are right by the geometry and as written, although the end view has its own scale."""
    clutch, found, drawing, document = drawn
    unit, alpha, radius = clutch.spec.control_unit, found.wall_angle, found.ball_diameter / 2
    relief = math.ceil(round(found.ball_diameter * 1e4 * 0.05, 6)) / 1e4
    cut, groove = radius - found.face_gap / 2, 2 * radius * (1 - math.sin(alpha)) / math.cos(alpha)
    rim, circle = 2 * (unit.ball_circle_radius + radius), unit.ball_circle_radius
    straight = 2 * (radius / math.sin(alpha) - found.face_gap / 2) * math.tan(alpha)
    lengths = [found.face_gap, cut, cut + relief, drawing.sleeve.depth, groove, found.pocket_width, 2 * radius]
    lengths += [straight] if found.wall is not None else []
    lengths += [2 * circle, rim, unit.hub_diameter or drawing.sleeve.bore, 2 * radius + relief]
    wanted = sorted([1e3 * length for length in lengths] + [math.degrees(2 * alpha), 360 / unit.balls])
    space = document.modelspace()
    measured, written = [], []
    for line in space.query("DIMENSION"):
        value = line.get_measurement()
        # ezdxf may measure an angle or its complement to 360°
        measured.append(min(value, 360 - value) if line.dimtype == 2 else value * line.override().get("dimlfac"))
        (text,) = (part.plain_text() for part in line.virtual_entities() if part.dxftype() == "MTEXT")
        text = text.replace("<>", f"{measured[-1]:.9g}")  # older ezdxf leaves this placeholder for the measured value
        written.append(float(re.sub(f"[Ø*°]|^{unit.balls}×", "", text)))
    assert sorted(measured) == pytest.approx(wanted, rel=1e-6)
    assert sorted(written) == pytest.approx(wanted, abs=0.0501), "of no tolerance, to a tenth"


def test_every_ball_has_its_pocket_in_the_end_view(drawn):
    clutch, found, drawing, document = drawn
    unit = clutch.spec.control_unit
    space = document.modelspace()
    pitch = next(circle for circle in space.query('CIRCLE[layer=="CENTRE"]'))
    scale = pitch.dxf.radius / (unit.ball_circle_radius * 1e3)
    balls = [ball for ball in space.query('CIRCLE[layer=="BALL"]') if ball.dxf.center.magnitude > 1e-9]
    places = np.array([(ball.dxf.center - pitch.dxf.center).vec2 for ball in balls])
    assert {round(ball.dxf.radius, 9) for ball in balls} == {round(found.ball_diameter * 500 * scale, 9)}
    assert np.hypot(*places.T) == pytest.approx(pitch.dxf.radius)
    angles = np.sort(np.degrees(np.arctan2(places[:, 1], places[:, 0])) % 360)
    assert np.diff(angles) == pytest.approx(360 / unit.balls)
    pockets = [line for line in space.query('LWPOLYLINE[layer=="END_VIEW"]') if len(line) > 2]
    assert len(pockets) == len(balls) == unit.balls
    for seat in pockets:
        ends = np.array([point[:2] for point in seat.get_points()]) - np.array(pitch.dxf.center.vec2)
        along = np.exp(1j * np.arctan2(ends[:, 1], ends[:, 0]))
        turn = np.abs(np.angle(along[0] / along[-1]))
        assert turn == pytest.approx(found.pocket_width / unit.ball_circle_radius)
        assert np.angle(along[0] / along[1]) == pytest.approx(0, abs=1e-12), "the walls run towards the axis"
        assert np.hypot(*ends[1:-1].T) == pytest.approx(drawing.sleeve.pocket_end * 1e3 * scale)


SHOP = {"tolerance": "±0.02 mm", "roughness": "Ra 0.8", "hardness": "58…62 HRC", "material": "16MnCr5"}


def test_what_the_shop_needs_is_on_the_sheet(afmcalc, tmp_path):
    given = overrides(*(f"drawing.{name}={text}" for name, text in SHOP.items()))
    given += overrides("report.drawing=AFM 01.02", "report.author=A_b Turner")
    spec = CONFIGS / "envelope.toml"
    assert afmcalc("pocket", spec, "-o", tmp_path / "plain.dxf").code == 0
    assert afmcalc("pocket", spec, "-o", tmp_path / "x.dxf", *given).code == 0
    document = ezdxf.readfile(tmp_path / "x.dxf")
    shown, plain = (
        " ".join(text.dxf.text for text in ezdxf.readfile(tmp_path / name).modelspace().query("TEXT"))
        for name in ("x.dxf", "plain.dxf")
    )
    for text in (*SHOP.values(), "AFM 01.02", "A_b Turner"):
        assert text in shown
        assert text not in plain
    lines = {layer.dxf.name: (layer.dxf.linetype, layer.dxf.lineweight) for layer in document.layers}
    assert lines["CENTRE"] == ("CENTER2", 18)
    assert lines["POCKET_1"] == lines["END_VIEW"] == ("CONTINUOUS", 50)
    assert {entity.dxf.layer for entity in document.modelspace()} <= set(lines) - {"0"}


@pytest.mark.parametrize("name", ["envelope", *slow("default")])
def test_section_in_true_millimetres(name, afmcalc, tmp_path):
    path = tmp_path / "s.dxf"
    assert afmcalc("layout", CONFIGS / f"{name}.toml", "-o", path).code == 0
    document = ezdxf.readfile(path)
    assert not document.audit().has_issues
    space = document.modelspace()
    wanted = section(Answers(build(read_spec(CONFIGS / f"{name}.toml")))).measures.values()
    measured = sorted(line.get_measurement() for line in space.query("DIMENSION"))
    assert measured == pytest.approx(sorted((each.high - each.low) * 1e3 for each in wanted))
    shown = [float(re.search(r"([\d.]+) ?\*?$", line.dxf.text)[1]) for line in space.query("DIMENSION")]
    assert sorted(shown) == pytest.approx(measured, abs=0.0501)
    assert all(len(whole(line)) > 1 for line in space.query("LWPOLYLINE"))
    assert all(line.closed for line in space.query('LWPOLYLINE[layer=="OUTLINE"]'))


def test_svg_has_the_contours_in_true_millimetres(drawn):
    _, found, drawing, _ = drawn
    sheet = pocket(drawing)
    root = ElementTree.fromstring(svg(sheet))
    name = "{http://www.w3.org/2000/svg}"
    assert (root.get("width"), root.get("height")) == ("420mm", "297mm")
    groups = {group.get("class"): group for group in root.iter(f"{name}g")}
    assert float(groups["ball"].find(f"{name}circle").get("r")) == pytest.approx(found.ball_diameter * 500, abs=1e-4)
    for contour in drawing.contours:
        path = groups[contour.layer.lower()].find(f"{name}path").get("d")
        numbers = np.array(re.findall(r"-?[\d.]+", path), float).reshape(-1, 2)
        assert numbers == pytest.approx(np.array(contour.points) * [1e3, -1e3], abs=1e-4)
        assert path.endswith("Z") == contour.closed


@pytest.mark.parametrize(("tolerance", "written"), [("±0.002 mm", "20.299"), (None, "20.3")])
def test_a_calculated_length_is_as_its_tolerance(tolerance, written, afmcalc, tmp_path):
    """The width of a pocket, 20.2985 mm, has as many decimals as the tolerance; the ball those of its standard."""
    more = ["--set", f"drawing.tolerance={tolerance}"] if tolerance else []
    assert afmcalc("pocket", "example:indirect", "-o", tmp_path / "x.dxf", *more).code == 0
    space = ezdxf.readfile(tmp_path / "x.dxf").modelspace()
    texts = {round(line.get_measurement(), 4): line.dxf.text for line in space.query("DIMENSION")}
    assert (texts[20.2985], texts[19.05]) == (written, "Ø19.05")


def test_what_is_refused(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for asked, said in REFUSED["shop"]:
        what, options = asked.split(" -o ")[0].split(), ["-o", *asked.split(" -o ")[1].split()]
        run = afmcalc(*what, CONFIGS / "constant-torque.toml", *options)
        assert (run.code, said in run.err, [*tmp_path.iterdir()]) == (2, True, []), run.err
