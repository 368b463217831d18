"""Places in texts: every key of any TOML and JSON is found where it stands."""

import json
import tomllib

import tomli_w
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.spec.source import Source, place_at, spans

KEYS = st.text(st.sampled_from("ab =#[]{}\"',:-\\é\t"), min_size=1, max_size=4)
"""Without the dot, which parts a path."""
VALUES = st.recursive(
    st.one_of(st.integers(-99, 99), st.booleans(), st.floats(-9, 9), st.text("ab#\"'\\\n=]},", max_size=5)),
    lambda inner: st.lists(inner, max_size=3),
    max_leaves=4,
)
TABLES = st.recursive(VALUES, lambda inner: st.dictionaries(KEYS, inner, max_size=3), max_leaves=8)


def leaves(value, path=""):
    """Every value below by its path, those of lists by number."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        own = f"{path}.{key}" if path else str(key)
        if not isinstance(inner, dict):
            yield own, inner
        yield from leaves(inner, own)


@given(st.dictionaries(KEYS, TABLES, max_size=4))
def test_every_value_is_found(data):
    as_toml, as_json = tomli_w.dumps(data), json.dumps(data, indent=1)
    for text, read in ((as_toml, lambda part: tomllib.loads(f"x = {part}")["x"]), (as_json, json.loads)):
        found = spans(text)
        for path, value in leaves(data):
            assert read(text[found[path].value : found[path].end]) == value


def test_toml_as_people_write_it():
    text = """# [no.table]
a.b = 1 # gain = 2
'c.d' = \"\"\"
x = 1 "quoted"
\"\"\"
[e . "f"]   # head
g = { h = [1, 2,
  3], i = 'x' }
[[j]]
k = 1979-05-27T07:32:00Z
"""
    found = spans(text)
    assert {path: text[span.value : span.end] for path, span in found.items() if "\n" not in text[span.value : span.end]} == {
        "a.b": "1", "e.f": '[e . "f"]', "e.f.g.h.0": "1", "e.f.g.h.1": "2", "e.f.g.h.2": "3", "e.f.g.i": "'x'",
        "j": "[[j]]", "j.k": "1979-05-27T07:32:00Z",
    }  # fmt: skip
    assert text[found["c.d"].key : found["c.d"].name_end] == "'c.d'"
    place = place_at(text, found["e.f.g"].value, found["e.f.g"].end)
    assert (str(place), place.width, place.text) == ("7:5", 12, "g = { h = [1, 2,")


def test_a_long_line_is_cut_around_what_is_meant():
    text = "a" * 300 + " = 1"
    line, caret = place_at(text, 303, 304).shown()
    assert (line[:6], len(line), line[caret.index("^")]) == ("  1 | ", 57, "1")


def test_what_is_overridden_has_no_place():
    source = Source("x.toml", "[a]\nb = 1\nc = 2").but(["a.b"])
    assert source.place("a.b") is None
    assert str(source.place("a.c")) == "3:5"
    assert str(source.place("a.d")) == "1:1"
