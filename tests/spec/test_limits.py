"""Anything too large is refused before any work begins, with the limit in the message."""

import json
import os
import time

import pytest
from conftest import CONFIGS

from afmcalc.errors import LONGEST_LINE, SpecError
from afmcalc.spec import make_spec
from afmcalc.spec.parse import DEEPEST, LONGEST_TEXT, LONGEST_TOML, MOST_VALUES, Source, parse

DEFAULT = (CONFIGS / "default.toml").read_text(encoding="utf-8")
NINES = "9" * 5000


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("a" + ".a" * 100_000 + " = 1", "a key has more than 32 parts, the most there may be"),
        ("[" + "a . " * 50_000 + "a]", "a key has more than 32 parts, the most there may be"),
        ("a = " + "[" * 40 + "]" * 40, "is nested more than 32 levels deep"),
        ('{"a": ' * 1500 + "1" + "}" * 1500, "is nested more than 32 levels deep"),
        ("#" * (LONGEST_TOML + 1), "is larger than 256 KiB, the most for TOML"),
        (json.dumps({"a": [0] * MOST_VALUES}), "has more than 100,000 values"),
        ("a" * (LONGEST_TEXT + 1) + " = 1", "has more than 1,000 characters"),
        (f"name = '{'a' * (LONGEST_TEXT + 1)}'", "name: has more than 1,000 characters"),
        ("", "is empty; a clutch spec in TOML or JSON is wanted"),
        ('{"spec": [1]}', "its spec block is no object"),
        ('{"command": "x", "result": {}, "spec": null}', "the output of 'x' carries no clutch"),
        (f"a = {NINES}", "is not valid TOML: a number has too many digits"),
        (f"b.a = 0x{'f' * 5000}", "b.a: is beyond the range of numbers"),
        (f'{{"a": {NINES}}}', "is not valid JSON: a number has too many digits"),
    ],
    ids=lambda value: value if len(value) < 60 else "text",
)
def test_text_beyond_a_limit(text, says):
    start = time.process_time()
    with pytest.raises(SpecError) as error:
        parse(Source("text", text))
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


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["torque", "--set", f"gain={'[' * 1500}{']' * 1500}"], "…: is nested more than 32 levels deep\n"),
        (["torque", "--set", f"gain={NINES}"], "…: a number has too many digits\n"),
        (["torque", "--set", f"gain=0x{'f' * 5000}"], "…: is beyond the range of numbers\n"),
        (["torque", "--set", "F=1e1000000 N"], '= "1e1000000 N": must be finite; give a force'),
        (["torque", "--set", "F=1e-1000000 N"], '= "1e-1000000 N": must be greater than 0\n'),
        (["torque", "--set", f"F='{NINES} N'"], "…: has more than 1,000 characters\n"),
        (["torque", "--set", f"F='{NINES[:500]} N'"], "cannot be read as a number with a unit"),
        (["torque", "--set", f"{'a.' * 60_000}a=1"], "unknown key"),
        (["accuracy", "--sweep", f"C=0:1:{NINES}"], " points; at most 200,000 are swept\n"),
        (["accuracy", "--sweep", "C=0:1:200001"], "--sweep C=0:1:200001: 200001 points; at most 200,000 are swept\n"),
        (["accuracy", "--sweep", "C=0:1:500", "--sweep", "z=2:501:500"], "asks for 250,000 points; at most 200,000 are swept\n"),
        (["solve", f"{'K' * 100_000}=2"], "is no target"),
        (["torque", "--friction", NINES], "write a coefficient such as 0.3"),
    ],
)  # fmt: skip
def test_arguments_beyond_a_limit(arguments, says, afmcalc):
    start = time.process_time()
    run = afmcalc(*arguments)
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
    """JSON can spell what no file in UTF-8 holds, its own refusal as JSON included."""
    run = afmcalc("check", "-", "--json", stdin=f'{{"variant": "conventional", {part}}}')
    assert (run.code, [each["code"] for each in run.json["findings"]]) == (2, ["bad-spec"])
    assert "holds a lone surrogate, which is no character" in run.err


def test_errors_stay_short():
    """Twenty problems of many, no line too long, wherever the text came from."""
    data = parse(Source("text", DEFAULT)) | {f"key{number}": "x" * 900 for number in range(1500)}
    with pytest.raises(SpecError) as error:
        make_spec(data, "spec.toml")
    assert str(error.value).splitlines()[20:] == ["spec.toml: and 1,480 more"]
    with pytest.raises(SpecError) as error:
        make_spec(parse(Source("text", DEFAULT)) | {"k" * 900: 1}, "s" * 300)
    assert [len(line) for line in str(error.value).splitlines()] == [LONGEST_LINE]


@pytest.mark.parametrize("number", [NINES, "-5", "nonsense"])
def test_a_nonsense_number_of_the_environment(number, afmcalc, monkeypatch):
    """Taken as a width it harms no table, as a date it is refused."""
    with pytest.MonkeyPatch.context() as patch:  # pytest -v, which reports right after, would not bear it
        patch.setenv("COLUMNS", number)
        assert [afmcalc(*line.split()).code for line in ("torque", "help keys")] == [0, 0]
    monkeypatch.setenv("SOURCE_DATE_EPOCH", number)
    assert (afmcalc("report").code, afmcalc("report").out) == (2, "")
