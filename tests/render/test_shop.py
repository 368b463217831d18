"""Drawings for the shop: the DXF read back, its contours held against the wall by distance; SVG and CSV alike."""

import csv
import io
import math
import re
import xml.etree.ElementTree as ElementTree

import ezdxf
import numpy as np
import pytest
from conftest import CONFIGS

from afmcalc.analysis.shop import shop_drawing
from afmcalc.analysis.synthesize import synthesize
from afmcalc.analysis.wall import CHORD, wall_of
from afmcalc.engines import build
from afmcalc.render.shop import LAYERS, dxf, profile, svg
from afmcalc.spec import read_spec

CLUTCHES = {
    "one": ("constant-torque", ()),
    "both": ("constant-torque", ("control_unit.profiled=both", "control_unit.gain=2")),
    "straight": ("indirect", ()),
    "direct": ("default", ()),
}


@pytest.fixture(scope="module", params=CLUTCHES)
def drawn(request):
    name, overrides = CLUTCHES[request.param]
    clutch = build(read_spec(CONFIGS / f"{name}.toml", overrides))
    found, _ = synthesize(clutch)
    return clutch, found, shop_drawing(clutch, found, cutter=0.6 * found.ball_diameter)


def read(drawing):
    document = ezdxf.read(io.StringIO(dxf(drawing).decode("utf-8")))
    assert not document.audit().has_issues
    return document


def distances(points, wall, start, stop):
    """Of places from the wall (mm), which is the distance of the path (sampled, then by its chords) less the ball."""
    depth = np.linspace(start, stop, 20001)
    path = np.stack([depth, depth * wall.tangent + wall.steepening * depth**2 / 2]) * 1e3
    found = []
    for point in points:
        gaps = np.hypot(*(path - np.array(point)[:, None]))
        i = int(np.clip(np.argmin(gaps), 1, len(depth) - 2))
        # the parabola through three samples: the sampling is no error of the drawing
        a, b, c = gaps[i - 1 : i + 2] ** 2
        found.append(math.sqrt(b - (c - a) ** 2 / (8 * (a - 2 * b + c))) - wall.ball_radius * 1e3)
    return np.array(found)


def test_the_contours_are_the_wall(drawn):
    clutch, found, drawing = drawn
    document = read(drawing)
    assert document.header["$INSUNITS"] == 4
    space = document.modelspace()
    assert {layer.dxf.name for layer in document.layers} >= set(LAYERS)
    (first,) = space.query('LWPOLYLINE[layer=="POCKET_1"]')
    assert first.closed
    assert not space.query("SPLINE LINE POLYLINE")
    own = wall_of(clutch, found.face_gap, found.ball_diameter / 2)
    points = np.array([point[:2] for point in first.get_points()])
    upper = points[points[:, 1] > 0]
    curve = upper[upper[:, 0] <= found.face_gap * 500 + found.pocket_depth_cut * 1e3 - 1e-9]
    touching = curve[curve[:, 0] <= -own.at(0.0).wall_axial * 1e3 + 1e-9]
    off = distances(touching * [-1, 1], own, 0.0, own.mouth + 1e-3)
    assert off == pytest.approx(0, abs=1e-9)
    between = (touching[1:] + touching[:-1]) / 2
    inside = distances(between * [-1, 1], own, 0.0, own.mouth + 1e-3)
    assert np.abs(inside).max() <= CHORD * 1e3 * 1.001
    assert points[:, 1] == pytest.approx(-points[::-1, 1], abs=1e-12), "both hands alike"
    assert np.ptp(points[:, 1]) == pytest.approx(found.pocket_width * 1e3, abs=1e-9)
    assert np.ptp(points[:, 0]) == pytest.approx(found.pocket_depth_cut * 1e3, abs=1e-9)


def test_ball_sleeves_and_dimensions(drawn):
    _, found, drawing = drawn
    space = read(drawing).modelspace()
    (ball,) = space.query("CIRCLE")
    assert (ball.dxf.layer, ball.dxf.radius) == ("BALL", pytest.approx(found.ball_diameter * 500))
    for name in ("SLEEVE_1", "SLEEVE_2", "POCKET_2"):
        (line,) = space.query(f'LWPOLYLINE[layer=="{name}"]')
        assert line.closed
    told = sorted(round(line.get_measurement(), 6) for line in space.query("DIMENSION"))
    wanted = (found.face_gap, found.pocket_depth_cut, found.pocket_width, found.ball_diameter)
    assert told == pytest.approx(sorted(1e3 * value for value in wanted), abs=1e-6)
    shown = " ".join(text.dxf.text for text in space.query("TEXT"))
    assert f"{found.pocket_width * 1e3:.4f} mm wide" in shown
    assert dxf(drawing) == dxf(drawing)


def test_the_cutter_touches_and_does_not_cut_in(drawn):
    """Its centre is its radius off the wall it cuts, no nearer to the other, and its edge not below the floor."""
    clutch, found, drawing = drawn
    radius = drawing.cutter_radius * 1e3
    rows = list(csv.DictReader(io.StringIO(profile(drawing))))
    cutter = np.array([[float(row["cutter_axial [mm]"]), float(row["cutter_around [mm]"])] for row in rows])
    wall = np.array([[float(row["wall_axial [mm]"]), float(row["wall_around [mm]"])] for row in rows])
    assert np.hypot(*(cutter - wall).T) == pytest.approx(radius, rel=1e-12)
    floor = -(found.face_gap / 2 + found.pocket_depth_cut) * 1e3
    assert (cutter[:, 0] - radius).min() == pytest.approx(floor, abs=1e-9)
    pocket = np.array([point for each in drawing.contours if each.layer == "POCKET_1" for point in each.points]) * 1e3
    dense = np.concatenate([np.linspace(a, b, 60) for a, b in zip(pocket, pocket[1:], strict=False)]) * [-1, 1]
    for centre in cutter:
        assert np.hypot(*(dense - centre).T).min() >= radius - CHORD * 1.1e3
    assert float(rows[-1]["travel [mm]"]) >= found.travel_max * 1e3
    assert float(rows[0]["travel [mm]"]) <= 0


def test_svg_is_in_millimetres(drawn):
    _, found, drawing = drawn
    root = ElementTree.fromstring(svg(drawing))
    name = "{http://www.w3.org/2000/svg}"
    wide, high = (float(root.get(key).removesuffix("mm")) for key in ("width", "height"))
    box = [float(part) for part in root.get("viewBox").split()]
    assert box[2:] == [wide, high], "a unit is a millimetre"
    assert float(root.find(f".//{name}circle").get("r")) == pytest.approx(found.ball_diameter * 500)
    own = {each.layer: each for each in drawing.contours}
    for path in root.iter(f"{name}path"):
        contour = own[path.get("id")]
        numbers = np.array(re.findall(r"-?[\d.]+", path.get("d")), float).reshape(-1, 2)
        assert numbers == pytest.approx(np.array(contour.points) * [1e3, -1e3], abs=1e-6)
        assert path.get("d").endswith("Z") == contour.closed
        inside = (numbers >= box[:2]) & (numbers <= np.add(box[:2], box[2:]))
        assert inside.all()


def test_a_finer_chord(drawn):
    clutch, found, drawing = drawn
    finer = shop_drawing(clutch, found, chord=1e-8)
    if found.profiled is None:
        assert len(finer.profile) == 2
    else:
        assert len(finer.profile) > 5 * len(drawing.profile)
        assert 10 < len(drawing.profile) < 30, "theory, section 12: 19 chords hold 1 µm over 2.5 mm"


def test_from_the_command_line(afmcalc, tmp_path):
    spec = CONFIGS / "constant-torque.toml"
    run = afmcalc("plot", "pocket", spec, "-o", tmp_path / "p.dxf", "--profile", tmp_path / "w.csv", "--cutter", "10mm")
    assert (run.code, run.out) == (0, "")
    assert "wrote" in run.err
    assert not ezdxf.readfile(tmp_path / "p.dxf").audit().has_issues
    assert (tmp_path / "w.csv").read_text().startswith("travel [mm],wall_angle [deg],path_axial [mm]")
    assert afmcalc("plot", "pocket", spec, "-o", tmp_path / "p.svg").code == 0
    assert afmcalc("plot", "pocket", spec, "--profile", "-").out.count("\n") > 10


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("pocket", "-o", "x.dxf", "--cutter", "30mm"), "takes one of up to 16 mm"),
        (("pocket", "-o", "x.dxf", "--cutter", "10 kg"), "not a length"),
        (("pocket", "-o", "x.dxf", "--chord", "0 mm"), "must be greater than 0"),
        (("pocket", "-o", "x.png", "--profile", "w.csv"), "--profile goes with"),
        (("torque", "-o", "x.dxf"), "only plot pocket"),
        (("torque", "--profile", "w.csv"), "no use for --profile"),
        (("pocket", "-o", "x.dxf", "--set", "C=1"), "undercuts its curved wall"),
    ],
)
def test_what_is_refused(afmcalc, arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    what, *options = arguments
    run = afmcalc("plot", what, CONFIGS / "constant-torque.toml", *options)
    assert run.code == 2
    assert message in run.err
    assert not list(tmp_path.iterdir())
