"""The program as a person or a script calls it, and its progress bar."""

import contextlib
import io
import re
import subprocess
import sys

import pytest
from conftest import CONFIGS, ROOT, Run, overrides, slow
from jsonschema import Draft202012Validator
from sources import table

import afmcalc as package
from afmcalc import progress
from afmcalc.cli.main import main
from afmcalc.cli.options import Common

SPEC = CONFIGS / "default.toml"
ERRONEOUS = ["pocket", SPEC, "--set", "balls=60", "--set", "allowable_contact_force="]
"""Command line whose findings include two errors."""
GRAVE = ["check", SPEC, "-v", "--set", "C=2", "--set", "requirements.torque_max=50"]
"""Command line with findings of every level, which are not in the order of the levels."""


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
    """Run the program as a person does, with a terminal as all of its streams."""

    def run(*arguments, stdin="", term="xterm"):
        monkeypatch.setenv("TERM", term)
        monkeypatch.setattr(sys, "stdin", Terminal(stdin))
        out, err = contextlib.redirect_stdout(Terminal()), contextlib.redirect_stderr(Terminal())
        with out as out, err as err, pytest.raises(SystemExit) as ended:
            main([str(argument) for argument in arguments])
        return Run(ended.value.code, out.shown, err.shown)

    return run


def test_version_and_a_command_that_there_is_not(afmcalc):
    assert afmcalc("--version").out == f"afmcalc {package.__version__}\n"
    wrong = afmcalc("torqe")
    assert (wrong.code, "Did you mean 'torque'" in wrong.err) == (2, True)


@pytest.mark.parametrize(("command", "example", "light"), [
    (["torque"], None, "friction.mean=0.4"), (["simulate"], "drive", "drive.event.duration=0.002"),
    (["plot", "torque"], None, ""),
])  # fmt: skip
def test_without_spec_the_default_example_is_calculated_and_heads_the_table(command, example, light, answered):
    sets = overrides(*light.split())
    example = f"example:{example or 'default'}"
    run, drawn = answered(*command, *sets), command[0] == "plot"
    said = f"no SPEC given: this is {example} (afmcalc init writes a spec to start from)"
    named = run.out if drawn else f"{said}\n\n{answered(*command, example, *sets).out}"
    assert (run.code, run.out) == (0, named)
    assert run.err == (f"note: {said}\n" if drawn else "")
    assert drawn or answered(*command, *sets, "--json").out == answered(*command, example, *sets, "--json").out


MISUSED = [
    *(["torque", f"--friction={bad}"] for bad in ("x", "-1", "nan", "inf", "0.1,0.2,0.3", "0.1,0.2", "")),
    *(["accuracy", SPEC, "--sweep", bad] for bad in ("C=0..1", "C=0-1", "C=0 to 1", "R=80mm..120mm", "C=0:1")),
    *(["torque", *spec, "--set", bad, "0.7"] for bad in ("gain", "=0.7") for spec in ([], [SPEC])),
    *(["torque", "--json", "--format", "csv"], ["torque", "--format", "xml"]),
    *([*command, "--set", "C=1"] for command in (["list", "examples"], ["papers"])),
    ["torque", "--set", "F=1e308", "--set", "R=1e10 m"],
    ["accuracy", "--set", "friction.min=1e-320", "--set", "friction.mean="],
    ["simulate", *overrides(*(f"friction.{name}=1e-320" for name in ("min", "mean", "max")))],
    ["schema", "torqe"], ["init", "--kind", "drive", "--from", "indirect"], ["papers", "--claims", "--misprints"],
]  # fmt: skip


@pytest.mark.parametrize("arguments", MISUSED, ids=lambda each: " ".join(map(str, each)).replace(str(SPEC), "SPEC"))
def test_bad_usage_ends_with_2_and_says_of_what(arguments, afmcalc):
    run = afmcalc(*arguments)
    assert (run.code, run.out) == (2, "")
    option = next((each.partition("=")[0] for each in map(str, arguments[1:]) if each[0] == "-" != each), "torqe")
    assert option in run.err or "not finite" in run.err
    assert run.err.splitlines()[-1].startswith("error: ")


DESCRIBED = {name: [] for name in ("torque", "accuracy", "adjust", "overload", "life", "compare", "check")}
DESCRIBED |= {"papers": ["--id", "F11 (1)"], "solve": ["accuracy_factor=2"]}
DESCRIBED |= {"tolerance": ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"]}
DESCRIBED["design"] = [
    "example:requirements", "--set", "search.friction_group.pairs=8", "--set", "search.control_unit.gain=[0.8, 0.9]",
]  # fmt: skip
DESCRIBED["simulate"] = ["--set", "drive.event.duration=0.005"]


@pytest.mark.parametrize("command", DESCRIBED)
def test_a_schema_describes_what_is_printed(command, answered):
    """Every key that is printed is described, and every key that is described is printed."""
    lines = ("schema", command), (command, *DESCRIBED[command], "--json")
    schema, printed = (answered(*line).json for line in lines)
    Draft202012Validator(schema).validate(printed)
    result = schema["$defs"][schema["properties"]["result"]["$ref"].rpartition("/")[2]]
    assert schema["properties"].keys() == printed.keys()
    assert result["properties"].keys() == printed["result"].keys()


def test_a_schema_of_specs_has_every_key(answered):
    assert answered("schema").json["properties"].keys() == package.Spec.model_fields.keys()


def test_a_schema_in_russian_has_other_descriptions_alone(answered):
    english, russian = (answered("schema", "check", "--lang", name).out.splitlines() for name in ("en", "ru"))
    assert english != russian
    for line, other in zip(english, russian, strict=True):
        heads = {each.partition(":")[0].strip() for each in (line, other)}
        assert line == other or heads == {'"description"'}


ASKED = {
    "": {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w", "typer", "babel"},
    "--help": {"numpy", "pint", "sympy", "matplotlib", "scipy", "rich", "pydantic", "tomli_w", "babel"},
    "torque {} --json --lang ru": {"numpy", "pint", "rich", "tomli_w", "sympy", "matplotlib", "babel"},
    "accuracy {} --sweep C": {"matplotlib", "jinja2", "sympy", "pint", "afmcalc.render.plot.figure"},
}
"""Command line → modules that neither it nor the lines before it import; the first only imports the package."""


def test_what_a_command_line_imports(answered, tmp_path):
    (tmp_path / "si.json").write_text(answered("torque", SPEC, "--json").out, encoding="utf-8")
    asked = [
        sys.executable,
        "-c",
        table("programs")["imported"],
        *(line.format(tmp_path / "si.json") for line in ASKED),
    ]
    run = subprocess.run(asked, capture_output=True, text=True, cwd=ROOT, check=True)
    for (line, without), modules in zip(ASKED.items(), run.stdout.splitlines(), strict=True):
        assert "afmcalc" in modules.split()
        assert not without & {*modules.split()}, line


@pytest.mark.parametrize("lang", ["en", *slow("ru")])
@pytest.mark.parametrize("format_", ["table", "markdown", "csv", "json"])
def test_quiet_leaves_results_and_errors(format_, lang, answered):
    """--quiet leaves out notes and warnings, except in JSON, where they are data, and in a check, which judges them."""
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
    """So in tables, Markdown and beside CSV; JSON keeps the order of the analyses; a dumb terminal shows no colours."""
    levels = [each["level"] for each in answered(*GRAVE, "--json").json["findings"]]
    ranked = sorted(levels, key=[*COLOURS].index)
    assert set(levels) == {*COLOURS}
    assert levels != ranked
    for format_ in ("table", "markdown", "csv"):
        run = answered(*GRAVE, "--format", format_)
        lines = run.err if format_ == "csv" else run.out
        assert re.findall(r"^(?:- )?(?:\*\*)?(error|warning|info)", lines, re.MULTILINE) == ranked
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


LONG = """tolerance example:tolerance --set tolerance.samples=1000 --set tolerance.sobol_base=64
design example:requirements --set search.friction_group.pairs=8 --set search.control_unit.gain=0.5:1:4
plot pareto example:requirements --set search.friction_group.pairs=8 --set search.control_unit.gain=0.5:1:4
simulate example:drive --set drive.event.duration=0.002 --sweep drive.shaft_stiffness=1000,2000
check example:tolerance --set tolerance.samples=1000 --set tolerance.sobol_base=64 --set requirements.exceedance=0.5
life example:drive --set drive.event.duration=0.004""".splitlines()
"""Every command that may take long."""


class Screen(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def passes(monkeypatch):
    """Stop the clock; return a function that lets time pass."""
    now = [0.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])

    def passed(seconds):
        now[0] += seconds

    return passed


WHERE = [(Screen, False, True), (Screen, True, False), (io.StringIO, False, False)]


@pytest.mark.parametrize(("stream", "quiet", "shown"), WHERE)
def test_where_and_when_the_bar_appears(stream, quiet, shown, passes, monkeypatch):
    """It appears after a second, and disappears when the work ends."""
    monkeypatch.setattr(sys, "stderr", stream())
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    with Common("design", quiet=quiet).bar():
        progress.tell("searching", 0, 10)
        passes(0.9)
        progress.tell("searching", 1, 10)
        assert sys.stderr.getvalue() == ""
        passes(4.1)
        progress.tell("searching", 4, 10)
    written = sys.stderr.getvalue()
    assert (" 40%" in written) == ("searching" in written) == shown
    assert written.rstrip().endswith("\x1b[2K") == shown, "what it showed is gone"
    assert written.count("\x1b[?25h") == written.count("\x1b[?25l") == shown, "the cursor is there again"


@pytest.mark.parametrize("line", [*LONG[:2], *slow(*LONG[2:])])
def test_a_command_that_may_take_long_tells_how_far_it_is(line, afmcalc):
    shares = set()
    with progress.watched(lambda work, done, total: shares.add(done / total)):
        assert afmcalc(*line.split()).code == 0
    assert max(shares) == 1
    assert any(0 < share < 1 for share in shares)
