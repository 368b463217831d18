"""The program as a person or a script calls it."""

import csv
import io
import json
import os
import re
import subprocess
import sys
import tomllib

import pytest
from conftest import CONFIGS, ROOT
from texts import described as descriptions

import afmcalc as package
from afmcalc.analysis.check import check
from afmcalc.cli.main import COMMANDS
from afmcalc.engines import build
from afmcalc.render.formats import table
from afmcalc.result import Output
from afmcalc.spec import read_spec

VARIANTS = ["conventional", "differentiated", "all-driving", "indirect", "unlike-materials"]


def test_help_names_every_command(afmcalc):
    run = afmcalc("--help")
    assert run.code == 0
    for name in COMMANDS:
        assert f"  {name} " in run.out
        help_ = afmcalc(name, "--help")
        assert help_.code == 0
        assert f"afmcalc {name}" in help_.out.split("Options:")[0].split("\n", 1)[1], "an example"
    assert afmcalc("--version").out == f"afmcalc {package.__version__}\n"
    assert afmcalc("torqe").code == 2
    assert "Did you mean 'torque'" in afmcalc("torqe").err


def test_no_spec_means_the_base_clutch_and_says_so(afmcalc):
    run = afmcalc("torque")
    assert "built-in base clutch" in run.err
    assert run.out == afmcalc("torque", CONFIGS / "default.toml").out
    assert afmcalc("torque", "--quiet").err == ""


@pytest.mark.parametrize(
    ("command", "example", "light"),
    [
        (["simulate"], "drive", "drive.event.duration=0.02"),
        (["heat"], "drive", "drive.event.duration=0.02"),
        (["effects"], "drive", "friction.mean=0.4"),
        (["explain", "heat"], "drive", "drive.event.duration=0.02"),
        (["plot", "effects"], "drive", "friction.mean=0.4"),
        (["tolerance"], "tolerance", "tolerance.samples=2000"),
        (["springs"], None, "friction.mean=0.4"),
        (["explain", "life"], None, "friction.mean=0.4"),
    ],
)
def test_no_spec_means_what_the_command_can_calculate_and_a_note_says_which(command, example, light, afmcalc):
    run = afmcalc(*command, "--set", light)
    assert run.code == 0
    says = f"example:{example} is used (afmcalc init --kind {example} writes it)" if example else "built-in base clutch"
    assert says in run.err
    assert run.out == afmcalc(*command, f"example:{example or 'default'}", "--set", light).out


EVERYWHERE = ["torque", "accuracy", "check", "adjust", "life", "compare"]
PAIRS = [(c, n) for c in EVERYWHERE for n in ("default", "conventional", "unlike-materials", "all-driving", "indirect")]
PAIRS += [("overload", n) for n in ("default", "all-driving")]
PAIRS += [("synthesize", n) for n in ("default", "unlike-materials", "all-driving", "indirect")]


@pytest.mark.every(4)
@pytest.mark.parametrize(("command", "name"), PAIRS)
def test_file_standard_input_and_json_give_the_same(name, command, afmcalc):
    path = CONFIGS / f"{name}.toml"
    direct = afmcalc(command, path, "--json")
    assert direct.code == 0
    assert afmcalc(command, "-", "--json", stdin=path.read_text()).out == direct.out
    for first in ("torque", "life"):
        assert afmcalc(command, "-", "--json", stdin=afmcalc(first, path, "--json").out).out == direct.out


def test_torque_is_what_python_says(afmcalc):
    result = afmcalc("torque", "--json", "--friction", "0.3").json["result"]
    clutch = package.load()
    assert result["torque"] == {at: clutch.torque(f) for at, f in (("min", 0.1), ("mean", 0.3), ("max", 0.8))}
    assert [point["torque"] for point in result["points"]] == [clutch.torque(0.3)]
    unlike = CONFIGS / "unlike-materials.toml"
    points = afmcalc("torque", unlike, "--json", "--friction", "0.3", "--friction", "0.2,0.4").json["result"]["points"]
    clutch = package.load(unlike)
    assert [point["torque"] for point in points] == [clutch.torque(0.3), clutch.torque(0.2, 0.4)]
    assert points[1]["friction_driving"] == 0.2


@pytest.mark.parametrize("bad", ["x", "-1", "nan", "inf", "0.1,0.2,0.3", "0.1,0.2", ""])
def test_bad_friction(bad, afmcalc):
    run = afmcalc("torque", f"--friction={bad}")
    assert (run.code, run.out) == (2, "")
    assert "--friction" in run.err


def test_friction_outside_the_range_is_a_finding(afmcalc):
    findings = afmcalc("torque", "--friction", "0.9", "--json").json["findings"]
    assert [(f["code"], f["value"], f["limit"]) for f in findings] == [("friction-outside-range", 0.9, 0.8)]


@pytest.mark.parametrize("variant", VARIANTS)
def test_init_writes_a_spec_that_is_read(variant, afmcalc, tmp_path):
    target = tmp_path / "new.toml"
    assert afmcalc("init", target, "--variant", variant).code == 0
    data = tomllib.loads(target.read_text(encoding="utf-8"))
    assert data["variant"] == ("differentiated" if variant == "unlike-materials" else variant)
    before = target.read_bytes()
    refused = afmcalc("init", target)
    assert refused.code == 2
    assert "--force" in refused.err
    assert target.read_bytes() == before
    assert afmcalc("init", target, "--force").code == 0
    assert afmcalc("init", "-", "--variant", variant).out.encode() == before


def test_schema_describes_what_is_printed(afmcalc):
    spec_schema = json.loads(afmcalc("schema").out)
    assert set(spec_schema["properties"]) == set(package.Spec.model_fields)
    for command in (
        "torque",
        "accuracy",
        "adjust",
        "overload",
        "synthesize",
        "life",
        "compare",
        "materials",
        "equations",
        "reproduce",
        "check",
    ):
        schema = json.loads(afmcalc("schema", command).out)
        printed = afmcalc(command, "--json").json
        assert set(schema["properties"]) == set(printed)
        result = schema["$defs"][schema["properties"]["result"]["$ref"].rpartition("/")[2]]
        assert set(result["properties"]) == set(printed["result"])
    assert afmcalc("schema", "torqe").code == 2


WITH_ARGUMENTS = {
    "solve": ["accuracy_factor=2"],
    "design": [CONFIGS / "requirements.toml"],
    "tolerance": [CONFIGS / "tolerance.toml", "--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"],
}


@pytest.mark.parametrize("command", WITH_ARGUMENTS)
def test_schema_of_commands_that_need_arguments(command, afmcalc):
    schema = json.loads(afmcalc("schema", command).out)
    printed = afmcalc(command, *WITH_ARGUMENTS[command], "--json").json
    result = schema["$defs"][schema["properties"]["result"]["$ref"].rpartition("/")[2]]
    assert set(result["properties"]) == set(printed["result"])
    for format_ in ("table", "csv", "markdown"):
        assert afmcalc(command, *WITH_ARGUMENTS[command], "--format", format_).code == 0


def test_schema_of_requirements_and_of_the_tolerance_block(afmcalc):
    schema = json.loads(afmcalc("schema", "requirements").out)
    assert {"wanted", "search", "limits"} <= set(schema["properties"])
    spec = json.loads(afmcalc("schema").out)
    assert "fields" in spec["$defs"]["Tolerance"]["properties"]
    assert "Distribution" in spec["$defs"]


@pytest.mark.parametrize("described", [[], ["requirements"], ["torque"], ["check"]])
def test_a_schema_is_described_in_the_language_of_the_user(described, afmcalc):
    """Nothing else of it changes."""

    def without(part):
        if isinstance(part, list):
            return [without(each) for each in part]
        if not isinstance(part, dict):
            return part
        return {
            name: without(each) for name, each in part.items() if not (name == "description" and isinstance(each, str))
        }

    english, russian = (json.loads(afmcalc("schema", *described, "--lang", name).out) for name in ("en", "ru"))
    assert without(english) == without(russian)
    assert english["description"].isascii()
    for text in descriptions(russian):
        assert re.search("[А-Яа-я]", text) or not re.search("[A-Za-z]{4}", text), text


def test_formats_exclude_each_other(afmcalc):
    assert afmcalc("torque", "--json", "--format", "csv").code == 2
    assert afmcalc("torque", "--format", "xml").code == 2


def test_unwritable_and_missing_files_are_exit_3(afmcalc, tmp_path):
    assert afmcalc("torque", tmp_path / "none.toml").code == 3
    assert afmcalc("torque", "-o", tmp_path / "no" / "such" / "folder").code == 3


def test_a_result_beyond_the_range_of_numbers_is_an_error_for_people(afmcalc):
    run = afmcalc("torque", "--set", "F=1e308", "--set", "R=1e10 m")
    assert (run.code, run.out) == (2, "")
    assert "not finite" in run.err
    frictions = [part for name in ("min", "mean", "max") for part in ("--set", f"friction.{name}=1e-320")]
    for asked in (["accuracy", "--set", "friction.min=1e-320", "--set", "friction.mean="], ["simulate", *frictions]):
        tiny = afmcalc(*asked, "--json")
        assert (tiny.code, tiny.out) == (2, "")
        assert "not finite" in tiny.err


def test_nothing_heavy_is_loaded_for_help_and_import():
    for code in (
        "import afmcalc",
        "import sys; sys.argv = ['afmcalc', '--help']\nfrom afmcalc.cli.main import main\nmain()",
    ):
        loaded = _modules(code)
        assert not loaded & {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w"}, code


def test_si_numbers_need_neither_numpy_nor_pint_nor_rich(afmcalc, tmp_path):
    file = tmp_path / "si.json"
    file.write_text(afmcalc("torque", "--json").out)
    code = f"import sys; sys.argv = ['afmcalc', 'torque', {str(file)!r}, '--json']\nfrom afmcalc.cli.main import main\nmain()"
    assert not _modules(code) & {"numpy", "pint", "rich", "tomli_w"}


def _modules(code: str) -> set[str]:
    report = f"import atexit, sys\natexit.register(lambda: print(*sys.modules, file=sys.stderr))\n{code}"
    run = subprocess.run([sys.executable, "-c", report], capture_output=True, text=True, cwd=ROOT, check=True)
    return set(run.stderr.split())


def _shell(command: str, **environment: str) -> subprocess.CompletedProcess[str]:
    program = f"{sys.executable} -m afmcalc"
    return subprocess.run(
        ["bash", "-c", command.replace("afmcalc ", f"{program} ")],
        capture_output=True, text=True, cwd=ROOT, env={**os.environ, **environment}, check=False,
    )  # fmt: skip


def test_ascii_streams_do_not_fail():
    run = _shell("afmcalc accuracy --sweep C", PYTHONIOENCODING="ascii")
    assert run.returncode == 0
    assert run.stdout.isascii()


@pytest.mark.parametrize("command", ["materials", "equations", "reproduce"])
def test_commands_without_a_clutch_take_no_overrides_and_give_no_spec(command, afmcalc):
    assert afmcalc(command, "--set", "C=1").code == 2
    piped = afmcalc("torque", "-", stdin=afmcalc(command, "--json").out)
    assert piped.code == 2
    assert "carries no clutch" in piped.err


NOTED = ["accuracy", CONFIGS / "default.toml", "--sweep", "C=0:2:3"]
"""Calculated with a warning alone."""


@pytest.mark.parametrize("lang", ["en", "ru"])
@pytest.mark.parametrize("format_", ["table", "markdown", "csv", "json"])
def test_quiet_leaves_results_and_errors(format_, lang, afmcalc):
    """Whatever the language: the same result, without notes and warnings; JSON has its findings as data."""
    for arguments, kept in ((["life"], 0), (NOTED, 0), (ERRONEOUS, 2)):
        spoken = [*arguments, "--format", format_, "--lang", lang]
        run, quiet = afmcalc(*spoken), afmcalc(*spoken, "-q")
        assert run.code == quiet.code == 0
        if format_ == "json":
            assert (quiet.out, quiet.err) == (run.out, "")
            continue
        said = quiet.err if format_ == "csv" else quiet.out
        assert len(re.findall(r"\[[a-z-]+(?:, \S+)?\]$", said, re.MULTILINE)) == kept
        assert (quiet.out == run.out) == (format_ == "csv")
        assert format_ == "csv" or quiet.err == ""


ERRONEOUS = ["synthesize", CONFIGS / "default.toml", "--set", "balls=60", "--set", "allowable_contact_force="]
"""Calculated with two findings of level error, among others."""


def test_an_error_of_another_command_than_check_ends_with_0(afmcalc):
    run = afmcalc(*ERRONEOUS, "--json")
    assert run.code == 0
    assert [each["level"] for each in run.json["findings"]].count("error") == 2
    assert afmcalc("check", *ERRONEOUS[1:]).code == 1


def test_findings_stand_gravest_first_in_their_colours(afmcalc):
    """In tables, Markdown and CSV; JSON has them in the order of the analyses."""
    arguments = ["check", CONFIGS / "default.toml", "--set", "C=2", "--set", "requirements.torque_max=50"]
    levels = [each["level"] for each in afmcalc(*arguments, "--json").json["findings"]]
    ranked = sorted(levels, key=["error", "warning", "info"].index)
    assert set(levels) == {"error", "warning", "info"}
    assert levels != ranked
    for format_ in ("table", "markdown", "csv"):
        out = afmcalc(*arguments, "--format", format_).out
        assert re.findall(r"^(?:- )?(?:\*\*)?(error|warning|info)", out, re.MULTILINE) == ranked
    result, findings = check(build(read_spec(arguments[1], arguments[3::2])))
    shown = table.render(Output("check", "0", None, result, findings), True)
    colours = {"error": "1;31", "warning": "33", "info": "36"}
    assert re.findall(r"^\x1b\[([\d;]+)m(error|warning|info)", shown, re.MULTILINE) == [
        (colours[level], level) for level in ranked
    ]


def test_csv_of_a_check_has_requirements_and_limits(afmcalc):
    arguments = ["check", CONFIGS / "indirect.toml", "--set", "requirements.torque_max=300", "--set",
                 "requirements.cycles=1e6"]  # fmt: skip
    asked, run = afmcalc(*arguments, "--json").json, afmcalc(*arguments, "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(run.out)))
    for name in ("requirements", "limits"):
        listed, entries = [row for row in rows if row["level"] == name], asked["result"][name]
        assert len(listed) == len(entries) > 1
        for row, entry in zip(listed, entries, strict=True):
            for key, value in entry.items():
                text = "" if value is None else str(value).lower() if isinstance(value, bool) else value
                assert row[key] == text or float(row[key]) == value
    assert len(rows) == sum(map(len, (asked["findings"], asked["result"]["requirements"], asked["result"]["limits"])))


def test_csv_of_a_pick_is_the_clutch_picked(afmcalc):
    asked = ["design", CONFIGS / "machine.toml", "--no-simulate", "--pick", "2"]
    head, *rows = afmcalc(*asked, "--format", "csv").out.splitlines()
    assert len(rows) == 1
    picked = afmcalc(*asked, "--json").json["result"]["picked"][0]
    told = dict(zip((name.partition(" ")[0] for name in head.split(",")), rows[0].split(","), strict=True))
    assert (told["number"], float(told["closing_force"])) == ("2", picked["closing_force"])


def test_csv_of_a_curved_wall_has_the_values_of_the_control_unit(afmcalc):
    spec = CONFIGS / "constant-torque.toml"
    result = afmcalc("synthesize", spec, "--json").json["result"]
    rows = list(csv.DictReader(io.StringIO(afmcalc("synthesize", spec, "--format", "csv").out)))
    wall = result.pop("wall")
    assert [float(row["travel [m]"]) for row in rows] == [point["travel"] for point in wall]
    assert [float(row["wall_angle [rad]"]) for row in rows] == [point["wall_angle"] for point in wall]
    assert result.pop("wall_angle") == wall[0]["wall_angle"]
    given = {name: value for name, value in result.items() if value is not None}
    assert len(given) > 20
    for row in rows:
        named = {heading.partition(" [")[0]: text for heading, text in row.items()}
        for name, value in given.items():
            assert named[name] == value if isinstance(value, str) else float(named[name]) == value


@pytest.mark.parametrize("given", ["C=0..1", "C=0…1", "C=0-1", "C=0 – 1", "C=0 to 1", "R=80mm..120mm", "C=0:1"])
def test_a_range_written_otherwise_is_told_how(given, afmcalc):
    run = afmcalc("accuracy", CONFIGS / "default.toml", "--sweep", given)
    assert (run.code, run.out) == (2, "")
    assert run.err == f"error: --sweep {given}: write start:stop:count with a whole count of at least 2\n"
    assert afmcalc("accuracy", "--sweep", "C=1e-1,5e-1").code == 0


@pytest.mark.parametrize("spec", [[], [CONFIGS / "default.toml"]])
@pytest.mark.parametrize("given", [["gain", "0.7"], ["gain", "=", "0.7"], ["=0.7"]])
def test_an_override_without_its_equals_sign_is_told_of_it(given, spec, afmcalc):
    run = afmcalc("torque", *spec, "--set", *given)
    assert (run.code, run.out) == (2, "")
    assert run.err.startswith(f"error: --set {given[0]}: write PATH=VALUE, both and the equals sign in one word, for")
