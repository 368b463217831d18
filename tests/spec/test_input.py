"""What is wrong with an input is said with the place, the line, what, and the fix: each message by its exact text."""

import datetime
import json
import re
import tomllib
from copy import deepcopy

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import validate
from sources import REFUSED

from afmcalc.analysis.solve.solve import parse_target
from afmcalc.errors import FileError, SpecError
from afmcalc.messages import did_you_mean
from afmcalc.spec import Spec, make_spec, read_spec
from afmcalc.spec.edit import put, replaced, respecified
from afmcalc.spec.fields import keys_below
from afmcalc.spec.models import Ratio
from afmcalc.spec.read import spec_of
from afmcalc.spec.requirements import Requirements, Searched, make_requirements
from afmcalc.spec.source import Source

BASE = """\
variant = "differentiated"
[friction]
min = 0.1
max = 0.8
[friction_group]
pairs = 8
driving_pairs = 1
mean_radius = "100 mm"
[closing_spring]
force = "2 kN"
[control_unit]
gain = 0.5
ball_circle_radius = "50 mm"
"""


@pytest.mark.parametrize(("old", "new", "column", "width", "says"), REFUSED["line"])
def test_message_with_place_line_and_caret(old, new, column, width, says, afmcalc):
    text = BASE.replace(old + "\n", new + "\n" if new else "")
    assert text != BASE
    line = BASE.split("\n").index(old) + 1 + new.count("\n")
    if column < 0:  # the head of the table that lacks it
        line, column = BASE.split("\n").index("[friction]") + 1, 1
    shown = text.split("\n")[line - 1]
    run = afmcalc("torque", "-", stdin=text)
    assert (run.code, run.out) == (2, "")
    margin = " " * len(str(line))
    assert run.err == (
        f"error: standard input:{line}:{column}: {says}\n"
        f"  {line} | {shown}\n"
        f"  {margin} | {' ' * (column - 1)}{'^' * width}\n"
    )


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ('"gain": 0,5', "4:11: is not valid JSON: a decimal comma is not read: write 0.5"),
        ('"gain": 5 mm', '4:11: is not valid JSON: a number with a unit stands in quotes: "5 mm"'),
        ('"gain": "x"', '4:11: control_unit.gain = "x": cannot be read as a number with a unit; '
         "give a plain number such as 0.3"),
        ('"gian": 0.5', "4:3: control_unit.gian = 0.5: unknown key; did you mean 'gain'?"),
    ],
)  # fmt: skip
def test_places_in_json_also_inside_the_output_of_a_command(given, says, afmcalc):
    spec = afmcalc("torque", "-", "--json", stdin=BASE).json["spec"]
    del spec["control_unit"]
    rest = json.dumps(spec)[1:]
    for head, below in (("{", 0), ('{"command": "torque", "result": {"gain": 1},\n"spec": {', 1)):
        text = f'{head}\n"name": "x",\n"control_unit": {{\n  {given}\n}},\n{rest}' + "}" * below
        run = afmcalc("torque", "-", stdin=text)
        line, told = says.split(":", 1)
        assert run.err.startswith(f"error: standard input:{int(line) + below}:{told}\n"), run.err


def test_all_problems_at_once_each_with_its_line(afmcalc):
    text = BASE.replace("0.8", '"high"').replace("pairs = 8", "pairs = 2.5").replace("gain", "gian")
    err = afmcalc("torque", "-", stdin=text).err
    assert afmcalc("torque", "-", stdin=text.replace("\n", "\r\n")).err == err
    places = re.findall(r"^error: standard input:(\d+):(\d+): ([\w.]+)", err, re.M)
    assert [":".join(place) for place in places] == [
        *("4:7:friction.max", "6:9:friction_group.pairs", "12:1:control_unit.gian", "11:1:control_unit.gain")
    ]


def test_an_override_has_no_line_and_a_calculation_names_one(afmcalc):
    err = afmcalc("torque", "-", "--set", "gain=0,5", stdin=BASE).err
    assert err == 'error: standard input: control_unit.gain = "0,5": a decimal comma is not read: write 0.5\n'
    err = afmcalc("synthesize", "-", stdin=BASE.replace('ball_circle_radius = "50 mm"\n', "")).err
    assert err.startswith("error: standard input:11:1: control_unit.ball_circle_radius: required by synthesize\n")


@pytest.mark.parametrize(
    ("line", "says"), [("torque requirements", "no clutch"), ("design default", "no requirements")]
)
def test_the_wrong_kind_of_file_is_one_sentence(line, says, afmcalc):
    command, name = line.split()
    run = afmcalc(command, CONFIGS / f"{name}.toml")
    assert (run.code, run.err.count("\n"), says in run.err) == (2, 1, True)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig"])
def test_text_of_windows_is_read(encoding, afmcalc, tmp_path):
    """``>`` of PowerShell writes UTF-16 with its mark, an editor of Windows UTF-8 with one."""
    for name, text in (("a.toml", BASE), ("a.json", afmcalc("torque", "-", "--json", stdin=BASE).out)):
        (tmp_path / name).write_bytes(text.replace("\n", "\r\n").encode(encoding))
        assert afmcalc("torque", tmp_path / name).out == afmcalc("torque", "-", stdin=BASE).out
    (tmp_path / "balls.csv").write_bytes("diameter_mm\r\n25\r\n".encode(encoding))
    assert afmcalc("synthesize", "-", "--balls", tmp_path / "balls.csv", "--json", stdin=BASE).code == 0


@pytest.mark.parametrize(
    ("name", "encoding"),
    [("Муфта «А» № 2", "cp1251"), ("муфта", "koi8-r"), ("муфта", "cp866"), ("für groß", "latin-1")],
)
def test_other_bytes_say_where_and_how_to_put_it_right(name, encoding, afmcalc, tmp_path):
    """The encoding of Russian Windows is named, with what is read in it; other bytes are not guessed at."""
    raw = BASE.encode() + f"name = '{name}'".encode(encoding)
    line, byte = BASE.count("\n") + 1, next(at for at, value in enumerate(raw) if value > 127)
    (tmp_path / "a.toml").write_bytes(raw)
    run = afmcalc("torque", tmp_path / "a.toml")
    assert (run.code, run.out) == (2, "")
    guessed = f"Windows-1251 (cp1251), in which line {line} reads \"name = '{name}'\": save"
    assert (guessed if encoding == "cp1251" else f"is not UTF-8 text (line {line}, byte {byte})") in run.err


def test_own_lists_and_requirements_of_russian_windows_are_named_too(afmcalc, tmp_path):
    own = tmp_path / "own.csv"
    own.write_bytes("# из каталога завода\ndiameter_mm\n25\n".encode("cp1251"))
    for line in ("springs --materials", "springs --discs", "springs --balls", "design"):
        assert "own.csv: is not UTF-8 text but seems to be Windows-1251" in afmcalc(*line.split(), own).err


@pytest.mark.parametrize("target", ["accuracy_factor", "К_т", "K_t"])
def test_solve_takes_both_orders_names_symbols_and_paths(target, answered):
    for name, *words in (
        *((name, f"{target}=2", "example:default") for name in ("C", "gain", "С")),
        *((name, "example:default", f"{target}=2") for name in ("C", "control_unit.gain")),
    ):
        result = answered("solve", *words, "--for", name, "--json").json["result"]
        assert (result["path"], result["target"]) == ("control_unit.gain", "accuracy_factor")
        assert result["reached"] == pytest.approx(2, rel=1e-9)


@pytest.mark.parametrize("name", ["C", "gain", "control_unit.gain", "С"])
def test_sweep_and_set_take_names_symbols_and_paths(name, afmcalc):
    (swept,) = afmcalc("accuracy", "--sweep", f"{name}=0.25,0.5", "--json").json["result"]["sweep"]
    assert (swept["path"], swept["values"]) == ("control_unit.gain", [0.25, 0.5])
    assert afmcalc("torque", "--set", f"{name}=0.25", "--json").json["result"]["gain"] == 0.25


@pytest.mark.parametrize(("line", "says"), REFUSED["argument"])
def test_what_an_argument_names(line, says, answered):
    run = answered(*(word.replace(r"\n", "\n") for word in line.split()))
    assert (run.code, run.out) == (2, "")
    assert says in run.err
    assert "Value error" not in run.err


WEIRD = (True, "off", "2_000", 2.5, -1, float("inf"), [], [[1]], {"a": 1}, datetime.date(2020, 1, 1))


@pytest.mark.parametrize("values", [WEIRD[::5], pytest.param(WEIRD, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("make", "example"), [(make_spec, "tolerance"), (make_requirements, "requirements")])
def test_whatever_stands_at_a_key_is_told_in_our_words(make, example, values):
    data = tomllib.loads((CONFIGS / f"{example}.toml").read_text(encoding="utf-8"))
    model = Requirements if make is make_requirements else Spec
    for path in [*keys_below(model), "tolerance.fields.friction", "tolerance.fields.friction.spread"]:
        for value in values:
            changed = deepcopy(data)
            try:
                put(changed, path, value)
                make(changed)
            except FileError:
                assert path.startswith("catalogues.")  # the name of a file that is not there
            except SpecError as error:
                assert "Input should" not in str(error), (path, value)
                assert not re.search("pydantic|valid|instance|Error", str(error)), (path, value)


@pytest.mark.parametrize("wrong", ["gain = 0,5", 'gain = "x"\nballs = "6"'])
def test_check_of_a_bad_spec_prints_json_with_the_errors(wrong, afmcalc):
    text = BASE.replace("gain = 0.5", wrong)
    run = afmcalc("check", "-", "--json", stdin=text)
    plain = afmcalc("check", "-", stdin=text)
    assert run.code == plain.code == 2
    assert run.err == plain.err
    assert plain.out == ""
    said = [line.removeprefix("error: ") for line in plain.err.splitlines() if line.startswith("error: ")]
    assert [each["message"] for each in run.json["findings"]] == said
    assert {(each["level"], each["code"]) for each in run.json["findings"]} == {("error", "bad-spec")}
    assert run.json["result"] | {"passed": False, "errors": len(said)} == run.json["result"]
    validate(run.json, afmcalc("schema", "check").json)


TYPED = st.tuples(st.floats(0, 1), st.integers(0, 3), st.sampled_from("0.,=[]{}\"'# \nкН°:-\\\r\0“"))


@given(st.sampled_from(sorted(CONFIGS.glob("*.toml"))), st.booleans(), st.lists(TYPED, min_size=1, max_size=4))
def test_a_mistyped_file_is_a_spec_or_an_error_at_a_place_that_there_is(file, as_json, mistakes):
    text = file.read_text(encoding="utf-8")
    text = json.dumps(tomllib.loads(text), indent=1, ensure_ascii=False) if as_json else text
    for share, gone, typed in mistakes:
        at = int(share * len(text))
        text = text[:at] + typed + text[at + gone :]
    try:
        spec_of(Source("x", text))
    except SpecError as error:
        for place in (problem.place for problem in error.problems if problem.place):
            assert text.split("\n")[place.line - 1].removesuffix("\r") == place.text
            assert 1 <= place.column <= len(place.text) + 1


BARE = [
    # key = value → what is asked, or how it is refused
    ("friction_group.mean_radius", "0.4999", ""), ("friction_group.mean_radius", "0.5", '0.5 m; 0.5 mm? Write "0.5 mm" or "0.5 m"'),
    ("friction_group.mean_radius", "10", '10 m; 10 mm? Write "10 mm" or "10 m"'),
    ("friction_group.mean_radius", "100", 'and 100 m is too large: write "100 mm"'),
    ("friction_group.mean_radius", '"600 mm"', ""), ("friction_group.mean_radius", '"0.6 m"', ""), ("friction_group.mean_radius", '"12 m"', ""),
    ("control_unit.ball_circle_radius", "50", 'write "50 mm"'), ("control_unit.face_gap", "2", '2 m; 2 mm?'),
    ("closing_spring.force", "2", '2 N; 2 kN? Write "2 kN" or "2 N"'), ("closing_spring.force", "19.9", "19.9 kN?"),
    ("closing_spring.force", "20", ""), ("closing_spring.force", '"2 N"', ""),
    ("drive.speed", "1460", '1460 rad/s; 1460 rpm? Write "1460 rpm" or "1460 rad/s"'),
    ("drive.speed", "1000", ""), ("drive.speed", '"1460 1/min"', ""),
]  # fmt: skip


@pytest.mark.parametrize(("path", "value", "says"), BARE)
def test_a_number_without_a_unit_that_may_be_meant_in_another_is_asked_after(path, value, says, afmcalc):
    block, key = path.split(".")
    text = re.sub(rf"(?m)^{key} = .*\n", "", BASE)
    head = f"[{block}]\n"
    text = text.replace(head, f"{head}{key} = {value}\n") if head in text else f"{text}{head}{key} = {value}\n"
    for run in (
        afmcalc("torque", "-", "--json", stdin=text),
        afmcalc("torque", "-", "--json", "--set", f"{path}={value}", stdin=BASE),
    ):
        if "too large" in says or says.startswith("write"):
            assert run.code == 2
            assert f"{path} = {value}: a number without a unit is in SI, and" in run.err
            assert says in run.err
            continue
        asked = [each for each in run.json["findings"] if each["code"] == "number-without-unit"]
        assert [(each["level"], each["path"], each["value"]) for each in asked] == (
            [("warning", path, float(value))] if says else []
        )
        assert all(says in each["message"] for each in asked)
    if run.code == 0:  # what afmcalc writes is in SI: it is not asked after where it is read again
        again = afmcalc("torque", "-", "--json", stdin=run.out).json
        assert "number-without-unit" not in str(again["findings"])
        assert again["result"] == run.json["result"]


def bare(run):
    """Key and value of each number that is asked after."""
    return [(each["path"], each["value"]) for each in run.json["findings"] if each["code"] == "number-without-unit"]


def test_a_number_that_scatters_or_is_wanted_is_asked_after_too(afmcalc):
    text = (CONFIGS / "tolerance.toml").read_text(encoding="utf-8")
    few = ["--set", "tolerance.samples=1000", "--set", "tolerance.sobol_base=64", "--json"]
    run = afmcalc("tolerance", "-", *few, stdin=text.replace('spread = "5 %"', 'spread = "5 %", center = 2'))
    assert bare(run) == [("tolerance.fields.closing_spring.force.center", 2)]
    run = afmcalc("tolerance", "-", *few, stdin=text.replace('spread = "1 mm"', 'spread = "1 mm", max = 110'))
    assert (run.code, 'write "110 mm"' in run.err) == (2, True)
    run = afmcalc("solve", "--for", "c1", "travel_max=100", "example:indirect")
    assert (run.code, 'write "100 mm"' in run.err) == (2, True)
    machine = ["torque", "--json", "--set", 'machine.speed="1460 rpm"', "--set"]
    assert bare(afmcalc(*machine, "machine.power=499")) == [("machine.power", 499)]
    assert bare(afmcalc(*machine, "machine.power=500")) == []
    assert [each.code for each in parse_target("closing_force=2")[2]] == ["number-without-unit"]
    assert parse_target("closing_force=2 N")[2] == []


@pytest.mark.parametrize(
    "line",
    [
        "torque",
        "accuracy",
        "synthesize",
        "life",
        "check",
        "explain torque",
        "solve accuracy_factor=2",
        "compare",
        "compare --variants",
    ],
)
def test_every_command_asks(line, afmcalc):
    fatigue = (
        "[fatigue]\nendurance_limit = '400 MPa'\npolar_section_modulus = '15 cm^3'\nexponent = 6\nbase_cycles = 1e7\n"
    )
    run = afmcalc(*line.split(), "-", "--json", stdin=BASE.replace('"2 kN"', "2") + fatigue)
    assert ("closing_spring.force", 2) in bare(run)


def test_sweeps_and_designs_ask_too(afmcalc):
    assert "0.6 m; 0.6 mm?" in afmcalc("accuracy", "-", "--sweep", "R=0.6:0.8:2", stdin=BASE).out
    for unlikely in ("R=80:120:5", "R=0.1,80"):
        run = afmcalc("overload", "-", "--sweep", unlikely, stdin=BASE)
        assert (run.code, f"--sweep {unlikely}: " in run.err, 'write "80 mm"' in run.err) == (2, True, True)
    for likely in ("R=80 mm:120 mm:5", "R=0.6 m,0.7 m", "R=0.1:0.2:3"):
        run = afmcalc("accuracy", "-", "--sweep", likely, stdin=BASE)
        assert (run.code, "number-without-unit" in run.out) == (0, False)
    search = "--set search.pairs=8 --set search.gain=0.5 --set search.mean_radius="
    for radii, says in (
        ("{start=0.06,stop=0.6,count=3}", "0.6 m; 0.6 mm?"),
        ("{start=60,stop=140,count=3}", 'write "60 mm"'),
    ):
        run = afmcalc("design", "example:requirements", *f"{search}{radii}".split())
        assert says in run.out + run.err


def test_a_temperature_without_a_unit_asks_for_degrees(afmcalc):
    err = afmcalc("torque", "-", stdin=BASE + "[heat]\nambient = 20\n").err
    assert 'heat.ambient = 20: a number without a unit is in K, and must be at least 173.15: "20 degC"?\n' in err
    assert "at least 173.15\n" in afmcalc("torque", "-", stdin=BASE + '[heat]\nambient = "20 K"\n').err


@pytest.mark.parametrize(
    ("word", "known", "said"),
    [
        ("gаin", ["gain"], "; did you mean 'gain' (all Latin)?"),
        ("расе", ["pack"], "; did you mean 'pack'?"),  # not a letter of it is Latin
        ("РАСК", ["Pack"], "; did you mean 'Pack'?"),
        ("Gian", ["gain", "GAIN"], "; did you mean 'gain'?"),
        ("gain", ["gain"], ""), ("расе", ["расе", "pace"], ""), ("stone", ["gain"], ""), ("g" * 61, ["g" * 60], ""),
    ],
)  # fmt: skip
def test_look_alike_letters_are_compared_as_what_they_look_like(word, known, said):
    assert did_you_mean(word, known) == said


def test_each_letter_that_looks_like_a_latin_one_is_taken_for_it():
    for seen, meant in zip("АВЕКМНОРСТХавекморстх", "ABEKMHOPCTXabekmopctx", strict=True):
        assert did_you_mean(f"{seen}1", [f"{meant}1"]) == f"; did you mean '{meant}1' (all Latin)?"
        assert did_you_mean(f"wall_{seen}1", [f"wall_{meant}2"]) == f"; did you mean 'wall_{meant}2'?"


def test_a_range_by_steps_has_its_end():
    values = {0.3: [0.1, 0.2, 0.3], 0.35: [0.1, 0.2, 0.3], 0.2999: [0.1, 0.2]}  # (0.3 − 0.1)/0.1 is 1.9999999999999998
    for stop, expected in values.items():
        grid = Searched(Ratio).read({"start": 0.1, "stop": stop, "step": 0.1}).array()
        assert list(grid) == pytest.approx(expected, rel=1e-12)


def test_a_nominal_torque_takes_the_place_of_both_springs():
    """The forces as given are those of another torque."""
    spec = read_spec(CONFIGS / "indirect.toml", ["control_spring.force=2640"])
    assert replaced(spec, ["adjustment.nominal_torque"]) == dict.fromkeys(
        ("closing_spring.force", "control_spring.force"), "adjustment.nominal_torque"
    )
    other = respecified(spec, {"adjustment.nominal_torque": 300.0})
    assert (other.closing_spring.force, other.control_spring.force) == (None, None)
