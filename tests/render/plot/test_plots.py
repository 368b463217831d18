"""Every picture against its stored baseline; files of every kind, the same bytes every time; the refusals."""

import io
import json
import math
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import CONFIGS, ROOT, several
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.font_manager import FontProperties
from PIL import Image

import afmcalc as package
from afmcalc.analysis.answers import Answers
from afmcalc.analysis.curves import torque_curve
from afmcalc.analysis.figures import Request, gathered, plot_of
from afmcalc.analysis.registry import PLOTS
from afmcalc.engines import build
from afmcalc.messages import ENGLISH, language, named, speaking
from afmcalc.papers import FIGURES
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.chart import ChartAxis
from afmcalc.render.plot.figure import _figure, _settings, save
from afmcalc.render.plot.inline import _Renderer
from afmcalc.render.plot.paint import COLOURS, DASHES
from afmcalc.render.symbols import mathtext
from afmcalc.spec import read_spec
from afmcalc.spec.requirements import read_requirements

WISHES = CONFIGS / "requirements.toml"
BASELINE = Path(__file__).parent / "baseline"
DPI = 64
TOLERANCE = 4.0
"""Root mean square of the differences, of 255: another version of the font engine stays below, a missing curve is above."""

PICTURES = {
    "section": ("section", ["default"], {}),
    "section-indirect": ("section", ["envelope"], {}),
    "torque": ("torque", ["default"], {}),
    "torque-indirect": ("torque", ["indirect"], {}),
    "torque-unlike": ("torque", ["unlike-materials"], {}),
    "torque-several": ("torque", ["default", "indirect", "all-driving", "conventional"], {}),
    "accuracy": ("accuracy", ["default"], {}),
    "accuracy-several": ("accuracy", ["default", "indirect", "all-driving"], {}),
    "accuracy-peaks": ("accuracy", ["default"], {"sweep": "C=0:3:101"}),
    "accuracy-pairs": ("accuracy", ["default"], {"sweep": "z"}),
    "overload": ("overload", ["all-driving"], {}),
    "overload-differentiated": ("overload", ["default"], {}),
    "life": ("life", ["default"], {}),
    "life-several": ("life", ["default", "all-driving", "indirect"], {}),
    "pocket": ("pocket", ["default"], {}),
    "pocket-indirect": ("pocket", ["indirect"], {}),
    "effects": ("effects", ["effects"], {}),
    "springs": ("springs", ["springs"], {}),
    "simulate": ("simulate", ["drive"], {}),
    "tolerance": ("tolerance", ["tolerance"], {}),
    "tolerance-exact": ("tolerance", ["exact"], {}),
    "pareto": ("pareto", ["requirements"], {}),
    "pareto-two": ("pareto", ["closing_force,pairs"], {}),
    "pareto-panels": ("pareto", ["closing_force,accuracy_factor,ball_diameter"], {}),
    **{f"paper-{name}": ("paper", [name], {}) for name in FIGURES},
}


def sheet(name):
    kind, subjects, options = PICTURES[name]
    return sheet_of(kind, gathered(kind, Request([subject_of(kind, subject) for subject in subjects], **options)))


def subject_of(kind, subject):
    if kind == "paper":
        return subject
    if kind == "pareto":
        aims = [] if subject == "requirements" else [f"objectives={json.dumps(subject.split(','))}"]
        return read_requirements(CONFIGS / "requirements.toml", aims)
    if subject == "exact":
        only = ['tolerance.fields={"friction" = {distribution="uniform"}}']
        return Answers(build(read_spec(CONFIGS / "default.toml", only)))
    if subject == "springs":
        shape = "outer_diameter=0.04, inner_diameter=0.0204, thickness=1.5e-3, free_height=2.65e-3, series=6"
        return Answers(build(read_spec(CONFIGS / "indirect.toml", [f"closing_spring.disc={{{shape}}}"])))
    if subject == "effects":
        splines = ["spline_friction=0.1", "inner_spline_radius=0.075", "outer_spline_radius=0.125"]
        neglected = [
            *(f"friction_group.{each}" for each in splines),
            "heat.lining=0.5 mm",
            "closing_spring.stiffness=2e4",
        ]
        return Answers(build(read_spec(CONFIGS / "default.toml", neglected)))
    light = ["drive.motor_inertia=0.2"] if subject == "drive" else []
    return Answers(build(read_spec(CONFIGS / f"{subject}.toml", light)))


def pixels(content):
    return np.asarray(Image.open(io.BytesIO(content)).convert("RGB"), float)


def difference(first, second):
    return float(np.sqrt(np.mean((first - second) ** 2)))


@pytest.mark.every(2)
@pytest.mark.parametrize("name", PICTURES)
def test_picture(name):
    path = BASELINE / f"{name}.png"
    made = save(sheet(name), "png", DPI)
    if os.environ.get("AFMCALC_UPDATE"):
        few = Image.open(io.BytesIO(made)).convert("RGB").quantize(128, dither=Image.Dither.NONE)
        few.save(path, optimize=True)
    found, stored = pixels(made), pixels(path.read_bytes())
    assert found.shape == stored.shape
    assert difference(found, stored) <= TOLERANCE, f"{name} differs; AFMCALC_UPDATE=1 writes it anew: look at it"


def test_a_missing_curve_exceeds_the_tolerance():
    whole = sheet("paper-S22-3")
    panel = whole.panels[0]
    made = pixels(save(whole, "png", DPI))
    panel.lines[1] = panel.lines[1]._replace(y=[None] * len(panel.lines[1].y))
    assert difference(made, pixels(save(whole, "png", DPI))) > TOLERANCE


@pytest.mark.every(31)
@pytest.mark.parametrize("lang", [None, "ru"])
@pytest.mark.parametrize("name", PICTURES)
def test_no_title_is_cut(name, lang):
    """Neither in width nor in height, whatever the clutch is called; nor does it reach into what is drawn."""
    with speaking(language(lang) if lang else ENGLISH), _settings():
        own = sheet(name)
        for called in (own.name, "W" * 200, "a clutch $x_1$ of many words " * 9):
            figure = _figure(replace(own, name=called))
            FigureCanvasAgg(figure).draw()
            title = figure.texts[0]
            box = title.get_window_extent()
            assert 0 <= box.x0 < box.x1 <= figure.bbox.x1
            assert figure.axes[0].yaxis.label.get_window_extent().y1 < box.y0 < box.y1 <= figure.bbox.y1
            plain = re.sub(r"\$_\{\\mathregular\{(.*?)\}\}\$", r"_\1", title.get_text()).replace("\\$", "$")
            whole = str(own.title) + (named(called) and f" – {named(called)}")
            assert "".join(plain.split()).replace("–", "") == "".join(whole.split()).replace("–", "")


@pytest.mark.parametrize(("name", "same"), [("front", "pareto"), ("design", "pareto"), ("synthesize", "pocket")])
def test_a_plot_goes_by_the_name_of_its_command_too(name, same):
    assert plot_of(name) is PLOTS[same]


def test_the_front_is_drawn_by_every_name(afmcalc):
    few = [WISHES, "--set", "search.gain=[0.5, 0.7]", "--set", "search.mean_radius=0.1"]
    assert len({afmcalc("plot", name, *few).out for name in ("pareto", "front", "design")}) == 1


def test_every_kind_has_a_picture():
    assert {kind for kind, _, _ in PICTURES.values()} == set(PLOTS)


def test_a_temperature_is_drawn_on_its_scale():
    axis = ChartAxis("temperature", "θ", "K abs")
    assert axis.label == "temperature θ, °C"
    assert axis.shown([293.15, None]) == pytest.approx([20, math.nan], nan_ok=True)


def test_a_subscript_is_measured_small():
    renderer = _Renderer(9, 9, io.StringIO())

    def width(text, size=10.0):
        return renderer.get_text_width_height_descent(text, FontProperties(size=size), "$" in text)[0]

    assert width(mathtext("K_т,p max")) == pytest.approx(width("K") + width("т,p", 7) + width(" max"))


def test_styles_can_be_told_apart_without_colour():
    assert len(COLOURS) == len(set(COLOURS)) == len(set(map(str, DASHES)))


def test_same_spec_same_bytes(tmp_path):
    """From this process and from one with another hash seed, without a backend or a home of matplotlib."""
    code = "import sys; from afmcalc.cli.main import main\nfor each in sys.argv[2:]:\n"
    code += " try: main(['plot', 'torque', sys.argv[1], '-o', each, '--quiet'])\n except SystemExit as end: assert not end.code"
    nowhere = {"MPLBACKEND": "nonsense", "MPLCONFIGDIR": "/proc/none", "HOME": "/proc/none"}
    again = [tmp_path / f"again.{ending}" for ending in several(["svg"], ["svg", "png", "pdf"])]
    run = subprocess.run(
        [sys.executable, "-c", code, CONFIGS / "default.toml", *again],
        check=True, capture_output=True, env={**os.environ, **nowhere, "PYTHONHASHSEED": "7", "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert (run.stdout, run.stderr) == (b"", b"")
    starts = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}
    for each in again:
        made = save(sheet_of("torque", [torque_curve(package.load(CONFIGS / "default.toml"))]), each.suffix[1:])
        assert made.startswith(starts[each.suffix])
        assert made == each.read_bytes()


def test_a_users_settings_change_nothing(monkeypatch):
    import matplotlib as mpl

    own = sheet("accuracy")
    before = save(own, "svg")
    with mpl.rc_context({"font.size": 20, "lines.linewidth": 9, "axes.facecolor": "red"}):
        assert save(own, "svg") == before


def test_a_name_is_text(afmcalc, tmp_path):
    target = tmp_path / "x.svg"
    name = "<script>alert(1)</script> $x_1$ --> {}"
    assert afmcalc("plot", "torque", "--set", f"name={name}", "-o", target).code == 0
    assert "<script" not in target.read_text(encoding="utf-8")
    other = tmp_path / "other.toml"
    other.write_text((CONFIGS / "default.toml").read_text(encoding="utf-8"), encoding="utf-8")
    assert (
        afmcalc("plot", "torque", other, CONFIGS / "indirect.toml", "--set", "name=$a$_b", "-o", target, "-f").code == 0
    )


@pytest.mark.every(3)
@pytest.mark.parametrize("what", sorted(set(PLOTS) - {"pocket"}))
def test_without_a_file_it_is_drawn_as_text(what, afmcalc):
    own = {
        "paper": "S22-3",
        "pareto": WISHES,
        "tolerance": CONFIGS / "tolerance.toml",
        "simulate": CONFIGS / "drive.toml",
    }
    worn = ["--set", "heat.lining=0.5 mm", "--set", "closing_spring.stiffness=2e4"]
    more = {"effects": worn, "simulate": ["--set", "drive.motor_inertia=0.2"]}.get(what, [])
    run = afmcalc("plot", what, own.get(what, CONFIGS / "all-driving.toml"), *more)
    assert run.code == 0
    assert "┤" in run.out
    assert "\x1b" not in run.out
    assert max(map(len, run.out.splitlines())) <= 80


TEXTS = {
    "torque": ["torque", CONFIGS / "indirect.toml", "--set", f"name={'Муфта с очень длинным именем ' * 9}"],
    "tolerance": ["tolerance", CONFIGS / "tolerance.toml"],
    "paper": ["paper", "S22-2"],
    "springs": ["springs", CONFIGS / "constant-torque.toml"],
    "life": ["life", CONFIGS / "default.toml", CONFIGS / "indirect.toml", "--set", "F=1.2345678e-9"],
}


@pytest.mark.every(3)
@pytest.mark.parametrize("lang", ["en", "ru"])
@pytest.mark.parametrize("name", TEXTS)
def test_a_drawing_is_as_wide_as_its_terminal(name, lang, afmcalc, monkeypatch):
    """Frame and curve whole, no word of a text lost; in a pipe 80 columns, never below 40."""
    runs = {}
    for columns in (None, 20, 40, 60, 80, 120, 200):
        monkeypatch.setenv("COLUMNS", str(columns or ""))
        run = afmcalc("plot", *TEXTS[name], "--lang", lang)
        assert run.code == 0
        lines = run.out.splitlines()
        widest = 80 if columns is None else max(columns, 40)
        assert max(map(len, lines)) == widest
        assert {len(line) for line in lines if "└" in line} == {widest}
        frames = [line for line in lines if re.search("[┤│└]", line)]
        marks = {mark for line in frames for mark in re.split("[┤│]", line)[-1].replace(" ", "") if "└" not in line}
        told = [line for place, line in enumerate(lines) if line not in frames and "└" not in lines[place - 1]]
        runs[columns] = len(frames), marks, "".join("".join(told).split())
    assert runs[None] == runs[80]
    assert len({(frames, told) for frames, _, told in runs.values()}) == 1
    assert {marks == runs[200][1] for _, marks, _ in runs.values()} == {True}


@pytest.mark.parametrize("columns", [40, 60, 80, 120, 200])
def test_a_sketch_fits_its_terminal(columns, afmcalc, monkeypatch):
    """It is to scale, so not always as wide; its dimensions and parts are whole."""
    monkeypatch.setenv("COLUMNS", "400")
    whole = afmcalc("plot", "section", CONFIGS / "indirect.toml").out
    monkeypatch.setenv("COLUMNS", str(columns))
    own = afmcalc("plot", "section", CONFIGS / "indirect.toml").out
    assert max(map(len, own.splitlines())) <= columns
    assert own.partition("L_1 =")[2].split() == whole.partition("L_1 =")[2].split()


def test_the_curve_of_a_sweep_fits_its_terminal(afmcalc, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    for more in ([], ["--plot"]):
        *_, floor, numbers, symbol = afmcalc("accuracy", "--sweep", "C=0:1.25:11", *more, "--quiet").out.splitlines()
        assert floor.startswith("  └")
        assert (len(floor), numbers.split(), symbol) == (60, ["0", "0.5", "1"], "C".rjust(60))


@pytest.mark.parametrize("sweep", ["C", "z", "f_max"])
def test_plot_of_a_sweep(sweep, afmcalc):
    plain = afmcalc("accuracy", "--sweep", sweep).out
    drawn = afmcalc("accuracy", "--sweep", sweep, "--plot").out
    assert [len(re.findall("[┤│]", run)) for run in (plain, drawn)] == [8, 20]
    assert drawn.splitlines()[:12] == plain.splitlines()[:12]


def test_plot_of_a_grid_has_a_curve_for_each_outer_value(afmcalc):
    out = afmcalc("accuracy", "--sweep", "z=4,8", "--sweep", "C=0:1:9", "--plot").out
    assert "• z = 4" in out
    assert "x z = 8" in out
    assert afmcalc("life", "--sweep", "dT=100:300:9", "--plot").code == 0
    assert afmcalc("overload", "--sweep", "zC=0:5:9", "--plot").code == 0


@pytest.mark.parametrize("name", ["tolerance", "pareto"])
def test_a_picture_of_a_sample_or_a_search_is_the_same_every_time(name):
    assert sheet(name) == sheet(name)


def test_each_number_of_pairs_is_named_once():
    (panel,) = sheet("pareto").panels
    assert sorted(line.tag for line in panel.lines if line.tag) == sorted(f"z = {z}" for z in range(4, 17, 2))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["plot", "torqe"], "did you mean 'torque'"),
        (["plot", "torque", "-o", "x.gif"], ".png, .svg or .pdf"),
        (["plot", "torque", "--sweep", "C"], "no use for --sweep"),
        (["plot", "pocket"], "give a file"),
        (["plot", "pocket", "-", "-", "-o", "x.svg"], "read once"),
        (["plot", "pocket", CONFIGS / "conventional.toml", "-o", "x.svg"], "no control unit"),
        (["plot", "overload", CONFIGS / "indirect.toml", "-o", "x.svg"], "S22 treats"),
        (["plot", "overload", CONFIGS / "default.toml", CONFIGS / "default.toml", "-o", "x.svg"], "takes one SPEC"),
        (["plot", "accuracy", CONFIGS / "conventional.toml", "-o", "x.svg"], "conventional"),
        (["plot", "life", "--sweep", "C", "-o", "x.svg"], "dT"),
        (["plot", "paper", "-o", "x.svg"], "takes one NAME"),
        (["plot", "tolerance", CONFIGS / "default.toml", "-o", "x.svg"], "required by tolerance"),
        (["plot", "tolerance", CONFIGS / "tolerance.toml", "--model", "goodman", "-o", "x.svg"], "no use for --model"),
        (["plot", "pareto", "-o", "x.svg"], "takes one REQUIREMENTS"),
        (["plot", "pareto", WISHES, WISHES, "-o", "x.svg"], "takes one REQUIREMENTS"),
        (["plot", "pareto", WISHES, "--sweep", "C", "-o", "x.svg"], "no use for --sweep"),
        (["plot", "pareto", CONFIGS / "default.toml", "-o", "x.svg"], "no requirements"),
        (["plot", "pareto", WISHES, "--set", 'objectives=["pairs"]', "-o", "x.svg"], "two or more"),
        (["plot", "pareto", WISHES, "--set", "wanted.accuracy_factor=1", "-o", "x.svg"], "by: accuracy factor"),
        (["plot", "paper", "S22-9", "-o", "x.svg"], "S22-4"),
        (["accuracy", "--plot"], "give --sweep"),
        (["accuracy", "--sweep", "C", "--plot", "--json"], "under a table"),
    ],
)
def test_refusals(arguments, said, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = afmcalc(*arguments)
    assert (run.code, run.out) == (2, "")
    assert said in run.err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "module", "extra"),
    [
        (["plot", "torque", "-o", "x.svg"], "matplotlib", "plot"),
        (["report", "-o", "x.html"], "jinja2", "report"),
        (["report", "-o", "x.html"], "matplotlib", "report"),
    ],
)
def test_a_missing_extra_says_how_to_get_it(arguments, module, extra, afmcalc, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, module, None)
    run = afmcalc(*arguments)
    assert (run.code, run.out) == (2, "")
    assert f"pip install 'afmcalc[{extra}]'" in run.err
    assert module in run.err
    assert not list(tmp_path.iterdir())


def test_other_commands_load_none_of_it():
    code = "import sys; sys.argv = ['afmcalc', 'accuracy', '--sweep', 'C']\n"
    code += "import atexit\natexit.register(lambda: print(*sys.modules, file=sys.stderr))\n"
    code += "from afmcalc.cli.main import main\nmain()"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not set(run.stderr.split()) & {"matplotlib", "jinja2", "afmcalc.render.plot.figure"}


def test_a_spec_is_not_written_over(afmcalc, tmp_path):
    spec = tmp_path / "clutch.svg"
    spec.write_text((CONFIGS / "default.toml").read_text(encoding="utf-8"), encoding="utf-8")
    assert afmcalc("plot", "torque", spec, "-o", spec).code == 2
    assert afmcalc("plot", "torque", "-o", tmp_path / "no" / "x.svg").code == 3
