"""The program as a person or a script calls it."""

import contextlib
import csv
import io
import json
import re
import subprocess
import sys

import pytest
from conftest import CONFIGS, ROOT, Run
from jsonschema import Draft202012Validator
from texts import described as descriptions

import afmcalc as package
from afmcalc.cli.main import COMMANDS, main

SPEC = CONFIGS / "default.toml"
ERRONEOUS = ["synthesize", SPEC, "--set", "balls=60", "--set", "allowable_contact_force="]
"""Calculated with two findings of level error, among others."""
GRAVE = ["check", SPEC, "--set", "C=2", "--set", "requirements.torque_max=50"]
"""Has findings of every level, and not in their order."""


class Terminal(io.TextIOWrapper):
    def __init__(self, text=""):
        super().__init__(io.BytesIO(text.encode()), "utf-8")

    def isatty(self):
        return True

    @property
    def shown(self):
        self.flush()
        return self.buffer.getvalue().decode()


@pytest.fixture
def at_a_terminal(monkeypatch):
    """Run the program as a person does, with a terminal at all of its streams."""

    def run(*arguments, stdin="", term="xterm"):
        monkeypatch.setenv("TERM", term)
        monkeypatch.setattr(sys, "stdin", Terminal(stdin))
        out, err = contextlib.redirect_stdout(Terminal()), contextlib.redirect_stderr(Terminal())
        with out as out, err as err, pytest.raises(SystemExit) as ended:
            main([str(argument) for argument in arguments])
        return Run(ended.value.code, out.shown, err.shown)

    return run


def test_help_and_version(afmcalc):
    shown = afmcalc("--help")
    assert shown.code == 0
    for name in COMMANDS:
        assert f"  {name} " in shown.out
    assert afmcalc("--version").out == f"afmcalc {package.__version__}\n"
    assert afmcalc("torqe").code == 2
    assert "Did you mean 'torque'" in afmcalc("torqe").err


@pytest.mark.parametrize(
    ("command", "example", "light"),
    [
        (["torque"], None, "friction.mean=0.4"),
        (["simulate"], "drive", "drive.event.duration=0.005"),
        (["explain", "life"], None, "friction.mean=0.4"),
        (["plot", "effects"], "drive", "friction.mean=0.4"),
        (["tolerance"], "tolerance", "tolerance.samples=2000"),
    ],
)
def test_no_spec_means_what_the_command_can_calculate_and_a_note_says_which(command, example, light, afmcalc):
    run, named = afmcalc(*command, "--set", light), afmcalc(*command, f"example:{example or 'default'}", "--set", light)
    assert (run.code, run.out) == (0, named.out)
    assert f"example:{example}" in run.err if example else "built-in base clutch" in run.err
    assert afmcalc(*command, "--set", light, "-q").err == ""


@pytest.mark.parametrize(
    ("command", "name"), [("check", "default"), ("synthesize", "indirect"), ("compare", "all-driving")]
)
def test_file_standard_input_and_json_give_the_same(name, command, answered):
    path = CONFIGS / f"{name}.toml"
    direct = answered(command, path, "--json")
    assert direct.code in (0, 1)
    assert answered(command, "-", "--json", stdin=path.read_text(encoding="utf-8")).out == direct.out
    for first in ("torque", "life"):
        assert answered(command, "-", "--json", stdin=answered(first, path, "--json").out).out == direct.out


def test_torque_at_frictions_of_ones_own(answered):
    unlike = CONFIGS / "unlike-materials.toml"
    points = answered("torque", unlike, "--json", "--friction", "0.3", "--friction", "0.2,0.4").json["result"]["points"]
    clutch = package.load(unlike)
    assert [point["torque"] for point in points] == [clutch.torque(0.3), clutch.torque(0.2, 0.4)]
    assert (points[1]["friction_driving"], points[1]["friction_driven"]) == (0.2, 0.4)
    findings = answered("torque", SPEC, "--friction", "0.9", "--json").json["findings"]
    assert [(each["code"], each["value"], each["limit"]) for each in findings] == [("friction-outside-range", 0.9, 0.8)]


MISUSED = [
    *(["torque", f"--friction={bad}"] for bad in ("x", "-1", "nan", "inf", "0.1,0.2,0.3", "0.1,0.2", "")),
    *(["accuracy", SPEC, "--sweep", bad] for bad in ("C=0..1", "C=0-1", "C=0 to 1", "R=80mm..120mm", "C=0:1")),
    *(["torque", *spec, "--set", bad, "0.7"] for bad in ("gain", "=0.7") for spec in ([], [SPEC])),
    *(["torque", "--json", "--format", "csv"], ["torque", "--excel", "--json"], ["torque", "--format", "xml"]),
    *([command, "--set", "C=1"] for command in ("materials", "equations", "reproduce")),
    ["torque", "--set", "F=1e308", "--set", "R=1e10 m"],
    ["accuracy", "--set", "friction.min=1e-320", "--set", "friction.mean="],
    ["simulate", *(part for name in ("min", "mean", "max") for part in ("--set", f"friction.{name}=1e-320"))],
    ["schema", "torqe"],
]  # fmt: skip


@pytest.mark.parametrize("arguments", MISUSED, ids=lambda each: " ".join(map(str, each)).replace(str(SPEC), "SPEC"))
def test_bad_usage_ends_with_2_and_says_of_what(arguments, afmcalc):
    run = afmcalc(*arguments)
    assert (run.code, run.out) == (2, "")
    option = next((each.partition("=")[0] for each in map(str, arguments[1:]) if each.startswith("-")), "torqe")
    assert option in run.err or "not finite" in run.err
    assert run.err.splitlines()[-1].startswith("error: ")


def test_what_carries_no_clutch_is_no_spec(answered):
    for command in ("materials", "equations", "reproduce"):
        piped = answered("torque", "-", stdin=answered(command, "--json").out)
        assert (piped.code, piped.out) == (2, "")
        assert "carries no clutch" in piped.err


def test_unwritable_and_missing_files_are_exit_3(afmcalc, tmp_path):
    assert afmcalc("torque", tmp_path / "none.toml").code == 3
    assert afmcalc("torque", "-o", tmp_path / "no" / "such" / "folder").code == 3


DESCRIBED = {name: [] for name in ("torque", "accuracy", "adjust", "overload", "life", "compare", "materials", "check")}
DESCRIBED |= {"equations": ["--id", "F11 (1)"], "reproduce": [], "solve": ["accuracy_factor=2"]}
DESCRIBED |= {"tolerance": ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"]}
DESCRIBED |= {
    "design": ["example:requirements", "--set", "search.pairs=8"],
    "simulate": ["--set", "drive.event.duration=0.005"],
}


def test_a_schema_describes_what_is_printed(answered):
    """Exactly: every key printed is described, and every key described is printed."""
    for command, arguments in DESCRIBED.items():
        schema, printed = json.loads(answered("schema", command).out), answered(command, *arguments, "--json").json
        Draft202012Validator(schema).validate(printed)
        result = schema["$defs"][schema["properties"]["result"]["$ref"].rpartition("/")[2]]
        assert schema["properties"].keys() == printed.keys()
        assert result["properties"].keys() == printed["result"].keys(), command
    assert json.loads(answered("schema").out)["properties"].keys() == package.Spec.model_fields.keys()
    assert {"wanted", "search", "limits"} <= json.loads(answered("schema", "requirements").out)["properties"].keys()


@pytest.mark.parametrize("described", [[], ["requirements"], ["check"]])
def test_a_schema_is_described_in_the_language_of_the_user(described, answered):
    """Nothing else of it changes."""

    def without(part):
        if isinstance(part, dict):
            return {key: without(each) for key, each in part.items() if key != "description" or isinstance(each, dict)}
        return [without(each) for each in part] if isinstance(part, list) else part

    english, russian = (json.loads(answered("schema", *described, "--lang", name).out) for name in ("en", "ru"))
    assert without(english) == without(russian)
    assert english["description"].isascii()
    for text in descriptions(russian):
        assert re.search("[А-Яа-я]", text) or not re.search("[A-Za-z]{4}", text), text


ASKED = {
    "": {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w", "typer", "babel"},
    "--help": {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w", "babel"},
    "torque {} --json --lang ru": {"numpy", "pint", "rich", "tomli_w", "sympy", "matplotlib", "babel"},
    "accuracy {} --sweep C": {"matplotlib", "jinja2", "sympy", "pint", "afmcalc.render.plot.figure"},
}
"""Command line → what it does without; the first only imports the package."""
IMPORTED = """
import json, os, sys
for given in json.loads(sys.argv[1]):
    if not os.fork():
        import afmcalc
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        try:
            if given:
                from afmcalc.cli.main import main
                main(given)
        except SystemExit as ended:
            assert not ended.code
        os.write(2, " ".join(sys.modules).encode() + b"\\n")
        os._exit(0)
    os.wait()
"""


def test_what_a_command_line_imports(answered, tmp_path):
    """Of each a process of its own, of which the first has imported nothing."""
    (tmp_path / "si.json").write_text(answered("torque", SPEC, "--json").out, encoding="utf-8")
    lines = json.dumps([line.format(tmp_path / "si.json").split() for line in ASKED])
    run = subprocess.run([sys.executable, "-c", IMPORTED, lines], capture_output=True, text=True, cwd=ROOT, check=True)
    for line, modules in zip(ASKED, run.stderr.splitlines(), strict=True):
        assert "afmcalc" in modules.split()
        assert not {*modules.split()} & ASKED[line], line


def test_ascii_streams_do_not_fail(afmcalc):
    run = afmcalc("accuracy", SPEC, "--sweep", "C", encoding="ascii")
    assert run.code == 0
    assert run.out.isascii()
    asked = ["torque", SPEC, "--set", "name=Муфта – 5 °", "--json"]
    told = afmcalc(*asked, encoding="ascii")
    assert told.out.isascii()
    assert told.json == afmcalc(*asked).json


@pytest.mark.parametrize("lang", ["en", "ru"])
@pytest.mark.parametrize("format_", ["table", "markdown", "csv", "json"])
def test_quiet_leaves_results_and_errors(format_, lang, answered):
    """Without notes and warnings; JSON has its findings as data, a check is about all of them."""
    for arguments, kept in ((["life"], 0), (["accuracy", SPEC, "--sweep", "C=0:2:3"], 0), (ERRONEOUS, 2)):
        spoken = [*arguments, "--format", format_, "--lang", lang]
        run, quiet = answered(*spoken), answered(*spoken, "-q")
        assert run.code == quiet.code == 0
        if format_ == "json":
            assert (quiet.out, quiet.err) == (run.out, "")
            continue
        said = quiet.err if format_ == "csv" else quiet.out
        assert len(re.findall(r"\[[a-z-]+(?:, \S+)?\]$", said, re.MULTILINE)) == kept
        assert (quiet.out == run.out) == (format_ == "csv")
        assert format_ == "csv" or quiet.err == ""
    checked = [*GRAVE, "--format", format_, "--lang", lang]
    assert answered(*checked, "-q") == answered(*checked)


def test_an_error_of_another_command_than_check_ends_with_0(answered):
    run = answered(*ERRONEOUS, "--json")
    assert run.code == 0
    assert [each["level"] for each in run.json["findings"]].count("error") == 2
    assert answered("check", *ERRONEOUS[1:]).code == 1


COLOURS = {"error": "1;31", "warning": "33", "info": "36"}


def test_findings_stand_gravest_first_in_their_colours(answered, at_a_terminal):
    """In tables, Markdown and CSV; JSON has them in the order of the analyses; a dumb terminal shows no colour."""
    levels = [each["level"] for each in answered(*GRAVE, "--json").json["findings"]]
    ranked = sorted(levels, key=[*COLOURS].index)
    assert set(levels) == {*COLOURS}
    assert levels != ranked
    for format_ in ("table", "markdown", "csv"):
        out = answered(*GRAVE, "--format", format_).out
        assert re.findall(r"^(?:- )?(?:\*\*)?(error|warning|info)", out, re.MULTILINE) == ranked
    shown = at_a_terminal(*GRAVE).out
    coloured = re.findall(r"^\x1b\[([\d;]+)m(error|warning|info)", shown, re.MULTILINE)
    assert coloured == [(COLOURS[level], level) for level in ranked]
    assert "\x1b" not in at_a_terminal(*GRAVE, term="dumb").out


def test_a_spec_that_is_typed_is_waited_for_with_a_note(at_a_terminal, answered):
    text = SPEC.read_text(encoding="utf-8")
    run, quiet = (at_a_terminal("torque", "-", *more, stdin=text, term="dumb") for more in ([], ["-q"]))
    assert run.out == quiet.out == answered("torque", SPEC).out
    assert re.fullmatch(r"note: .*Ctrl-D.*\n", run.err)
    assert quiet.err == ""


def test_csv_of_a_check_has_requirements_and_limits(answered):
    arguments = ["check", CONFIGS / "indirect.toml", "--set", "requirements.torque_max=300", "--set",
                 "requirements.cycles=1e6"]  # fmt: skip
    asked, rows = answered(*arguments, "--json").json, answered(*arguments, "--format", "csv").out
    rows, parts = list(csv.DictReader(io.StringIO(rows))), {"findings": asked["findings"]} | asked["result"]
    for name in ("requirements", "limits"):
        listed = [row for row in rows if row["level"] == name]
        for row, entry in zip(listed, parts[name], strict=True):
            for key, value in entry.items():
                text = "" if value is None else str(value).lower() if isinstance(value, bool) else value
                assert row[key] == text or float(row[key]) == value
    assert len(rows) == sum(len(parts[name]) for name in ("findings", "requirements", "limits")) > 6


def test_csv_of_a_curved_wall_has_the_values_of_the_control_unit(answered):
    asked = ["synthesize", CONFIGS / "constant-torque.toml"]
    result = answered(*asked, "--json").json["result"]
    rows = list(csv.DictReader(io.StringIO(answered(*asked, "--format", "csv").out)))
    wall = result.pop("wall")
    for name, unit in (("travel", "m"), ("wall_angle", "rad")):
        assert [float(row[f"{name} [{unit}]"]) for row in rows] == [point[name] for point in wall]
    assert result.pop("wall_angle") == wall[0]["wall_angle"]
    for row in rows:
        named = {heading.partition(" [")[0]: text for heading, text in row.items()}
        given = {name: value for name, value in result.items() if value is not None}
        assert given == {name: type(value)(named[name]) for name, value in given.items()}
        assert len(given) > 20
