"""The program as a person or a script calls it."""

import json
import os
import subprocess
import sys
import tomllib

import pytest
from conftest import CONFIGS, ROOT

import afmcalc as package
from afmcalc.cli.main import COMMANDS

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


EVERYWHERE = ["torque", "accuracy", "check", "adjust", "life", "compare"]
PAIRS = [(c, n) for c in EVERYWHERE for n in ("default", "conventional", "unlike-materials", "all-driving", "indirect")]
PAIRS += [("overload", n) for n in ("default", "all-driving")]
PAIRS += [("synthesize", n) for n in ("default", "unlike-materials", "all-driving", "indirect")]
FEW = {
    "torque": ("default", "unlike-materials"),
    "accuracy": ("conventional",),
    "check": ("indirect",),
    "adjust": ("all-driving", "indirect"),
    "life": ("unlike-materials",),
    "compare": ("default",),
    "overload": ("all-driving",),
    "synthesize": ("indirect",),
}
"""Every command and every clutch; the other pairs are exhaustive."""


@pytest.mark.parametrize(
    ("command", "name"), [pytest.param(c, n, marks=[] if n in FEW[c] else pytest.mark.exhaustive) for c, n in PAIRS]
)
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
    tiny = afmcalc("accuracy", "--set", "friction.min=1e-320", "--set", "friction.mean=", "--json")
    assert (tiny.code, tiny.out) == (2, "")
    assert "not finite" in tiny.err


def test_nothing_heavy_is_loaded_for_help_and_import():
    for code in (
        "import afmcalc",
        "import sys; sys.argv = ['afmcalc', '--help']\nfrom afmcalc.cli.entry import main\nmain()",
    ):
        loaded = _modules(code)
        assert not loaded & {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w"}, code


def test_si_numbers_need_neither_numpy_nor_pint_nor_rich(afmcalc, tmp_path):
    file = tmp_path / "si.json"
    file.write_text(afmcalc("torque", "--json").out)
    code = f"import sys; sys.argv = ['afmcalc', 'torque', {str(file)!r}, '--json']\nfrom afmcalc.cli.entry import main\nmain()"
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
