"""The message on a mistake names place, line, mistake and remedy; too large inputs are refused before any work."""

import json
import os
import re
import time
import tomllib

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import validate
from sources import DATA, READ, REFUSED

from afmcalc.analysis.solve import parse_target
from afmcalc.errors import LONGEST_LINE, AfmcalcError, SpecError
from afmcalc.messages import did_you_mean
from afmcalc.render.report.blocks import today
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import replaced, respecified
from afmcalc.spec.parse import DEEPEST, Source, parse
from afmcalc.spec.read import spec_of

BASE = (DATA / "base.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(("old", "new", "says"), REFUSED["line"])
def test_message_with_line(old, new, says, afmcalc):
    text = BASE.replace(old + "\n", new + "\n" if new else "")
    assert text != BASE
    line = BASE.split("\n").index(old) + 1 + new.count("\n") if new else BASE.split("\n").index("[friction]") + 1
    run = afmcalc("torque", "-", stdin=text)
    assert (run.code, run.out) == (2, "")
    first, shown = run.err.splitlines()
    assert first.startswith(f"error: standard input:{line}: {says}")
    assert shown == f"  {line} | {text.splitlines()[line - 1]}"


@pytest.mark.parametrize(("given", "says"), REFUSED["json"])
def test_problems_of_json_also_inside_the_output_of_a_command(given, says, afmcalc):
    spec = afmcalc("torque", "-", "--json", stdin=BASE).json["spec"]
    del spec["control_unit"]
    rest = json.dumps(spec)[1:]
    for head, below in (("{", 0), ('{"command": "torque", "result": {"gain": 1},\n"spec": {', 1)):
        text = f'{head}\n"name": "x",\n"control_unit": {{\n  {given}\n}},\n{rest}' + "}" * below
        run = afmcalc("torque", "-", stdin=text)
        assert re.match(rf"error: standard input(:\d+)?: {re.escape(says)}\n", run.err), run.err


def test_all_problems_at_once_each_with_its_line(afmcalc):
    text = BASE.replace("0.8", '"high"').replace("pairs = 8", "pairs = 2.5").replace("gain", "gian")
    err = afmcalc("torque", "-", stdin=text).err
    assert afmcalc("torque", "-", stdin=text.replace("\n", "\r\n")).err == err
    places = re.findall(r"^error: standard input:(\d+): ([\w.]+)", err, re.M)
    found = [":".join(place) for place in places]
    assert found[:2] == ["4:friction.max", "6:friction_group.pairs"]
    assert found[2:] == ["12:control_unit.gian", "11:control_unit.gain"]


def test_an_override_has_no_line_and_a_calculation_names_one(afmcalc):
    err = afmcalc("torque", "-", "--set", "gain=0;5", stdin=BASE).err
    assert err.startswith('error: standard input: control_unit.gain = "0;5": ')
    err = afmcalc("pocket", "-", stdin=BASE.replace('ball_circle_radius = "50 mm"\n', "")).err
    assert err.startswith("error: standard input:11: control_unit.ball_circle_radius: required by afmcalc pocket\n")


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig"])
def test_text_of_windows_is_read(encoding, afmcalc, tmp_path):
    """``>`` of PowerShell writes UTF-16 with its mark, an editor of Windows UTF-8 with one."""
    for name, text in (("a.toml", BASE), ("a.json", afmcalc("torque", "-", "--json", stdin=BASE).out)):
        (tmp_path / name).write_bytes(text.replace("\n", "\r\n").encode(encoding))
        assert afmcalc("torque", tmp_path / name).out == afmcalc("torque", "-", stdin=BASE).out
    (tmp_path / "balls.csv").write_bytes("diameter_mm\r\n25\r\n".encode(encoding))
    assert afmcalc("pocket", "-", "--set", f"catalogues.balls={tmp_path / 'balls.csv'}", "--json", stdin=BASE).code == 0


@pytest.mark.parametrize(("raw", "says"), [
    (BASE.encode() + "name = 'Муфта'".encode("cp1251"), "is not UTF-8 text (line 14): save it as UTF-8"),
    (b"%PDF-1.7 ...", "is a PDF; a spec is a text in TOML or JSON"),
])  # fmt: skip
def test_other_bytes_say_what_they_are(raw, says, afmcalc, tmp_path):
    (tmp_path / "a.toml").write_bytes(raw)
    run = afmcalc("torque", tmp_path / "a.toml")
    assert (run.code, run.out, run.err) == (2, "", f"error: {tmp_path / 'a.toml'}: {says}\n")


def test_a_missing_file_names_the_nearest_and_a_file_alone_the_command(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "clutch.toml").write_text(BASE)
    run = afmcalc("torque", "cluch.toml")
    assert (run.code, run.out) == (3, "")
    assert run.err.endswith("; did you mean 'clutch.toml'?\n")
    for name in ("clutch.toml", "example:default"):
        run = afmcalc(name)
        assert (run.code, run.err) == (2, f"error: {name} is no command; did you mean: afmcalc check {name}\n")


def test_a_key_is_named_by_name_symbol_or_path_and_solve_takes_both_orders(answered):
    for name, target in (("C", "accuracy_factor"), ("gain", "K_т"), ("control_unit.gain", "K_T")):
        for words in ((f"{target}=2", "example:default"), ("example:default", f"{target}=2")):
            result = answered("solve", *words, "--for", name, "--json").json["result"]
            assert (result["path"], result["target"]) == ("control_unit.gain", "accuracy_factor")
            assert result["reached"] == pytest.approx(2, rel=1e-9)
        (swept,) = answered("accuracy", "--sweep", f"{name}=0.25,0.5", "--json").json["result"]["sweep"]
        assert (swept["path"], swept["values"]) == ("control_unit.gain", [0.25, 0.5])
        assert answered("torque", "--set", f"{name}=0.25", "--json").json["result"]["gain"] == 0.25


@pytest.mark.parametrize(("line", "says"), REFUSED["argument"])
def test_what_an_argument_names(line, says, answered):
    run = answered(*(word.replace(r"\n", "\n") for word in line.split()))
    assert (run.code, run.out) == (2, "")
    assert says in run.err


@pytest.mark.parametrize("wrong", ["gain = 0,5", 'gain = "x"\nballs = "6"'])
def test_check_of_a_bad_spec_prints_json_with_the_errors(wrong, afmcalc):
    text = BASE.replace("gain = 0.5", wrong)
    run = afmcalc("check", "-", "--json", stdin=text)
    plain = afmcalc("check", "-", stdin=text)
    assert (plain.code, plain.out) == (2, "")
    assert (run.code, run.err) == (2, plain.err)
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
            assert text.split("\n")[place.line - 1] == place.text


def bare(run):
    """Key and value of each number without a unit on which there is a warning."""
    asked = [each for each in run.json["findings"] if each["code"] == "number-without-unit"]
    assert {each["level"] for each in asked} <= {"warning"}
    return [(each["path"], each["value"]) for each in asked]


@pytest.mark.parametrize(("path", "value", "says"), READ["bare"])
def test_a_number_without_a_unit_that_may_be_meant_in_another_is_asked_after(path, value, says, afmcalc):
    block, key = path.split(".")
    text = re.sub(rf"(?m)^{key} = .*\n", "", BASE)
    head = f"[{block}]\n"
    text = text.replace(head, f"{head}{key} = {value}\n") if head in text else f"{text}{head}{key} = {value}\n"
    asked = ["torque", "-", "--json"]
    for run in (afmcalc(*asked, stdin=text), afmcalc(*asked, "--set", f"{path}={value}", stdin=BASE)):
        if "too large" in says or says.startswith("write"):
            assert (run.code, says in run.err) == (2, True)
            assert f"{path} = {value}: a number without a unit is in SI, and" in run.err
            continue
        assert bare(run) == ([(path, float(value))] if says else [])
        assert says in run.out.replace('\\"', '"')
    if run.code == 0:  # what afmcalc writes is in SI: it is not asked after where it is read again
        again = afmcalc("torque", "-", "--json", stdin=run.out)
        assert (bare(again), again.json["result"]) == ([], run.json["result"])


def test_a_number_that_scatters_or_is_wanted_is_asked_after_too(afmcalc):
    text = (CONFIGS / "tolerance.toml").read_text(encoding="utf-8")
    few = ["--set", "tolerance.samples=1000", "--set", "tolerance.sobol_base=64", "--json"]
    run = afmcalc("tolerance", "-", *few, stdin=text.replace('spread = "5 %"', 'spread = "5 %", center = 2'))
    assert bare(run) == [("tolerance.fields.closing_spring.force.center", 2)]
    run = afmcalc("tolerance", "-", *few, stdin=text.replace('spread = "1 mm"', 'spread = "1 mm", max = 110'))
    assert (run.code, 'write "110 mm"' in run.err) == (2, True)
    assert 'write "100 mm"' in afmcalc("solve", "--for", "c1", "travel_max=100", "example:indirect").err
    machine = ["torque", "--json", "--set", 'machine.speed="1460 rpm"', "--set"]
    for power, asked in ((499, [("machine.power", 499)]), (500, [])):
        assert bare(afmcalc(*machine, f"machine.power={power}")) == asked
    assert [each.code for each in parse_target("closing_force=2")[2]] == ["number-without-unit"]
    assert parse_target("closing_force=2 N")[2] == []


@pytest.mark.parametrize("line", ["accuracy", "explain torque", "solve accuracy_factor=2", "compare --variants"])
def test_every_command_asks(line, afmcalc):
    assert ("closing_spring.force", 2) in bare(afmcalc(*line.split(), "-", "--json", stdin=BASE.replace('"2 kN"', "2")))


def test_sweeps_and_designs_ask_too(afmcalc):
    assert "0.6 m; 0.6 mm?" in afmcalc("accuracy", "-", "--sweep", "R=0.6:0.8:2", stdin=BASE).out
    for unlikely in ("R=80:120:5", "R=0.1,80"):
        run = afmcalc("overload", "-", "--sweep", unlikely, stdin=BASE)
        assert (run.code, f"--sweep {unlikely}: " in run.err, 'write "80 mm"' in run.err) == (2, True, True)
    for likely in ("R=80 mm:120 mm:5", "R=0.6 m,0.7 m", "R=0.1:0.2:3"):
        run = afmcalc("accuracy", "-", "--sweep", likely, stdin=BASE)
        assert (run.code, "number-without-unit" in run.out) == (0, False)


def test_a_temperature_without_a_unit_asks_for_degrees(afmcalc):
    err = afmcalc("torque", "-", stdin=BASE + "[heat]\nambient = 20\n").err
    assert "heat.ambient = 20: must be at least 173.15 K (-100 degC); a number without a unit is in K\n" in err
    assert "at least 173.15 K" in afmcalc("torque", "-", stdin=BASE + '[heat]\nambient = "20 K"\n').err


def test_the_nearest_known_word_is_suggested():
    for word, known, said in REFUSED["meant"]:
        assert did_you_mean(word, known.split()) == said


def test_a_nominal_torque_takes_the_place_of_both_springs():
    """The given forces are dropped, because they belong to another torque."""
    spec = read_spec(CONFIGS / "indirect.toml", ["control_spring.force=2640"])
    taken = replaced(spec, ["adjustment.nominal_torque"])
    assert taken == dict.fromkeys(("closing_spring.force", "control_spring.force"), "adjustment.nominal_torque")
    other = respecified(spec, {"adjustment.nominal_torque": 300.0})
    assert (other.closing_spring.force, other.control_spring.force) == (None, None)


def test_the_line_of_a_key():
    """The line of a key is found in TOML as people write it; for a missing key it is that of its table."""
    text = """# [no.table]
a.b = 1 # gain = 2
'c.d' = "x"
[e . "f"]   # head
g = { h = [1, 2,
  3], i = 'x' }
[j]
k = 1
"""
    places = {"a.b": 2, "c.d": 3, "e.f": 4, "e.f.x": 4, "e.f.g.i": 5, "j.k": 8, "j.l": 7}
    for path, line in places.items():
        place = Source("x", text).place(path)
        assert (place.line, place.text) == (line, text.split("\n")[line - 1]), path
    assert Source("x", text).place("z") is None


DEFAULT = (CONFIGS / "default.toml").read_text(encoding="utf-8")


def repeated(text):
    """A text, what is to be in it many times repeated."""
    return re.sub(r"⟨(.+?)×(\d+)⟩", lambda part: part[1] * int(part[2]), text)


@pytest.mark.parametrize(("text", "says"), REFUSED["limit_text"])
def test_text_beyond_a_limit(text, says):
    start = time.process_time()
    with pytest.raises(SpecError) as error:
        parse(Source("text", repeated(text)))
    assert [str(problem) for problem in error.value.problems] == [says]
    assert time.process_time() - start < 2


def test_what_is_within_every_limit_is_read():
    deep = "[" * (DEEPEST - 1) + "]" * (DEEPEST - 1)
    assert parse(Source("text", f"{DEFAULT}\n[x]\n{'.'.join('a' * (DEEPEST - 3))} = 1\n[y]\nz = {deep}"))["variant"]
    assert "1.2.3" in parse(Source("text", "name = '" + "1.2.3," * 50 + "'"))["name"]
    output = json.dumps({"command": "x", "result": {"a": [0.5] * 200_000}, "spec": {"variant": "y"}})
    assert parse(Source("text", output)) == {"variant": "y"}


@pytest.mark.skipif(not os.path.exists("/dev/zero"), reason="no endless file")
def test_an_endless_file_is_not_read_to_its_end(afmcalc):
    run = afmcalc("torque", "/dev/zero")
    assert (run.code, run.err) == (2, "error: /dev/zero: is larger than 64 MiB, the most that is read\n")


@pytest.mark.parametrize(("arguments", "says"), REFUSED["limit_argument"])
def test_arguments_beyond_a_limit(arguments, says, afmcalc):
    start = time.process_time()
    run = afmcalc(*map(repeated, arguments))
    assert time.process_time() - start < 2
    assert (run.code, run.out) == (2, "")
    assert says in run.err
    assert max(map(len, run.err.splitlines())) <= 400


def test_a_sweep_without_a_range_has_as_many_points_as_one_can_look_at(afmcalc):
    pairs = 10**18
    (swept,) = afmcalc("accuracy", "--set", f"z={pairs}", "--sweep", "z", "--json").json["result"]["sweep"]
    values = swept["values"]
    assert (values[0], values[-1], len(values)) == (2, 2 * pairs, 200)
    assert all(value == int(value) for value in values)


@pytest.mark.parametrize("part", ['"name": "\\ud800"', '"\\udfff": 1', '"tolerance": {"fields": ["\\ud800"]}'])
def test_half_a_character_is_refused(part, afmcalc):
    """JSON can spell half a character, which UTF-8 cannot hold; the refusal is JSON too."""
    run = afmcalc("check", "-", "--json", stdin=f'{{"variant": "conventional", {part}}}')
    assert (run.code, {each["code"] for each in run.json["findings"]}) == (2, {"bad-spec"})


def test_errors_stay_short():
    """At most twenty problems are listed, and no line is too long, wherever its text comes from."""
    data = parse(Source("text", DEFAULT)) | {f"key{number}": "x" * 900 for number in range(1500)}
    with pytest.raises(SpecError) as error:
        make_spec(data, "spec.toml")
    assert str(error.value).splitlines()[20:] == ["spec.toml: and 1,480 more"]
    with pytest.raises(SpecError) as error:
        make_spec(parse(Source("text", DEFAULT)) | {"k" * 900: 1}, "s" * 300)
    assert [len(line) for line in str(error.value).splitlines()] == [LONGEST_LINE]


@pytest.mark.parametrize("number", ["9" * 5000, "-5", "nonsense"])
def test_a_nonsense_number_of_the_environment(number, afmcalc, monkeypatch):
    """As a width of the terminal it does no harm; as a date it is refused."""
    with pytest.MonkeyPatch.context() as patch:  # pytest -v, which reports right after, would not bear it
        patch.setenv("COLUMNS", number)
        assert [afmcalc(*line.split()).code for line in ("torque", "help keys")] == [0, 0]
    monkeypatch.setenv("SOURCE_DATE_EPOCH", number)
    with pytest.raises(AfmcalcError, match="SOURCE_DATE_EPOCH"):
        today()
