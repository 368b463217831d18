"""Aids of the page: the strip of results, entries, a result that is held, remedies, help, other clutches, files."""

import base64
import json
import re
import shlex
from html import unescape

import pytest
from conftest import CONFIGS, slow
from pages import Site, cells, is_shown, sets, spec_in, tags, web
from sources import READ

pytestmark = web


@pytest.fixture(scope="module")
def drive(afmcalc, tmp_path_factory):
    return Site(afmcalc, spec_in(tmp_path_factory.mktemp("drive"), "drive"))


def tiles(html):
    """Text and class of each tile, by its title."""
    found = re.findall(r'<li class="([^"]*)" title="([^"]*)">(.*?)</li>', html, re.DOTALL)
    return {title: (" ".join(unescape(re.sub("<[^>]*>", " ", text)).split()), kind) for kind, title, text in found}


def test_the_strip_has_what_a_clutch_is_designed_for(drive):
    """What is simulated follows with the check; a tile has the grade of its requirements; a part that lacks is named."""
    at_once = tiles(drive.live({})["fragments"]["strip"])
    assert len(at_once) == 6
    waiting = [title for title, (text, _) in at_once.items() if "Calculating…" in text]
    assert waiting == ["temperature of the faces, or of the discs", "peak torque in the shaft"]
    fields = {"drive.event.duration": "0.005 s", "requirements.peak_torque": "1"}
    whole = tiles(drive.tab("check", fields)["strip"])
    assert not [title for title, (text, _) in whole.items() if "Calculating…" in text]
    assert whole["peak torque in the shaft"][1] == "is-fail"
    assert "is-pass" in whole["accuracy factor"][1]
    assert "needs [envelope]" in whole["diameter and length of the clutch"][0]


def test_a_tile_names_what_its_number_needs(site):
    needs = {
        kind: text.partition("needs ")[2] for kind, (text, _) in tiles(site.live({})["fragments"]["strip"]).items()
    }
    assert needs["surface pressure in the mean"] == "inner_radius, outer_radius"
    assert needs["peak torque in the shaft"] == "[drive] with an event"


def test_a_tile_has_the_pinned_value_where_it_is_another(site):
    """F11 (12) is proportional to the force, of which the accuracy factor is free."""
    pinned = {"base": 0, "fields": {"closing_spring.force": "1"}}
    strip = tiles(site.live({"closing_spring.force": "1.25"}, pinned=pinned)["fragments"]["strip"])
    assert "+25.0%" in strip["trip torque"][0]
    assert "pinned" not in strip["accuracy factor"][0]


@pytest.mark.parametrize(("key", "text", "same", "entry"), READ["entry"])
def test_a_bare_number_is_in_the_unit_at_the_field(site, afmcalc, key, text, same, entry):
    """Of a sum the result is told for its field."""
    told = site.live({key: text})
    result = afmcalc("torque", "example:default", *sets({key: same}), "--json").json["result"]
    shown = [float(cells(told["fragments"]["numbers"])[f"normal_force.{end}"]) for end in ("min", "max")]
    assert shown == pytest.approx([result["normal_force"][end] for end in ("min", "max")], rel=1e-9)
    assert told["entries"] == ({key: entry} if entry else {})


@pytest.mark.parametrize("gain", [0.5, 0.8])
def test_a_result_is_held(site, gain):
    """F11 (12) at the smallest friction, 8 pairs of 100 mm, f = 0.1: T_min = 0.08 F/(1 + 0.7 C)."""
    hold = {"hold": "torque_min", "as": "100", "by": "closing_spring.force"}
    body = {"base": 0, "fields": {"control_unit.gain": str(gain)}, "pinned": None, "options": hold}
    told = site.post("live", body).json
    assert float(told["entries"]["closing_spring.force"]) == pytest.approx(1.25 * (1 + 0.7 * gain), rel=1e-6)
    (text, _) = tiles(told["fragments"]["strip"])["trip torque"]
    assert " 100…" in text
    begun = site.post("live", body | {"options": hold | {"as": ""}}).json
    assert (float(begun["as"]), begun["entries"]) == (pytest.approx(160 / (1 + 0.7 * gain), rel=1e-4), {})
    for wrong in ({"as": "1e9"}, {"as": "x"}, {"by": "no.such"}):
        assert site.post("live", body | {"options": hold | wrong}).json["errors"].keys() == {"hold-as"}, wrong


def test_what_mends_a_finding_clears_it(site):
    """Each button that fills fields in; a code that is not found has none."""
    fields = {"control_unit.gain": "2"}
    found = [tag for tag in tags(site.live(fields)["fragments"]["verdict"], "data-code").values() if "data-path" in tag]
    assert found
    for tag in found:
        way = tags(site.tab("mend", fields, code=tag["data-code"], path=tag["data-path"])["html"], "data-go")
        fills = {path: json.loads(button["data-fill"]) for path, button in way.items()}
        assert [path for path, filled in fills.items() if path in filled]
        for filled in fills.values():
            left = tags(site.live(fields | filled)["fragments"]["verdict"], "data-code").values()
            assert (tag["data-code"], tag["data-path"]) not in [(one["data-code"], one["data-path"]) for one in left]
    assert "data-go" not in site.tab("mend", {}, code="no-such", path="")["html"]


def test_a_finding_of_an_event_names_its_keys(drive):
    html = drive.tab("mend", {}, code="event-contact-force", path="control_unit.contact")["html"]
    ways = tags(html, "data-go")
    assert "drive.shaft_stiffness" in ways
    assert {way["data-fill"] for way in ways.values()} == {"{}"}
    assert "Decrease drive.shaft_stiffness" in html


@pytest.mark.parametrize(
    ("key", "has"),
    [("control_unit.gain", "tan"), ("heat.specific_heat", "Θ"), ("shaft.diameter", "W"), ("envelope.bore", "<svg")],
)
def test_help_is_a_formula_or_a_sketch(drive, key, has):
    html = drive.tab("help", {}, key=key)["html"]
    assert has in html
    assert ("<math" in html) != (has == "<svg")
    assert drive.tab("help", {}, key="no.such")["problems"]


def opened(site, **wanted):
    """The number of a clutch that is opened."""
    told = site.post("open", wanted).json
    return int(tags(told["html"], "value")[tags(told["html"], "id")["base"]["value"]]["value"]), told


def test_other_clutches_are_opened(afmcalc, tmp_path):
    """An example, the text of a file; neither is written over the file of this one unasked."""
    spec, text = spec_in(tmp_path), f"{(CONFIGS / 'indirect.toml').read_text(encoding='utf-8')}# mine\n"
    site, before = Site(afmcalc, spec, "--force"), spec.read_bytes()
    for wanted, command in (
        ({"example": "conveyor"}, ["example:conveyor"]),
        ({"label": "i.toml", "text": text}, ["-"]),
    ):
        base, told = opened(site, **wanted)
        assert "[search]" in told["requirements"]
        live = site.live({}, base=base)
        stdin = text if command == ["-"] else ""
        is_shown(cells(live["fragments"]["numbers"]), afmcalc("torque", *command, "--json", stdin=stdin).json["result"])
        assert shlex.split(live["command"].partition("\n")[0])[2] == command[0]
        assert "another clutch" in site.save({}, base=base)["message"]
        assert spec.read_bytes() == before
    assert site.save({"control_unit.gain": "0.7"}, base=base, download=True)["text"].endswith("# mine\n")
    assert site.save({}, base=base, anyway=True)["saved"]
    assert site.save({}, base=base)["saved"], "it is the clutch of the file now"
    assert spec.read_bytes().endswith(b"# mine\n")


def test_what_is_no_clutch_is_not_opened(site, tmp_path):
    (tmp_path / "own.csv").write_text("secret 4711", encoding="utf-8")
    for text in ("", "gain = [", "[search]\n", f'[catalogues]\nmaterials = "{tmp_path / "own.csv"}"\n'):
        told = site.post("open", {"label": "x.toml", "text": text}).json
        assert told.keys() == {"errors", "problems"}
        assert "4711" not in str(told)
    for example in ("no-such", "../default"):
        assert site.post("open", {"example": example}).json.keys() == {"errors", "problems"}


@pytest.mark.parametrize("kind", ["csv", "dxf", *slow("pdf")])
def test_files_are_those_of_the_commands(site, afmcalc, undrawn, kind):
    content = base64.b64decode(site.tab(kind, {"control_unit.gain": "0.7"})["file"])
    if kind == "csv":
        run = afmcalc("torque", "example:default", "--set", "control_unit.gain=0.7", "--format", "csv")
        assert content.decode().splitlines() == run.out.splitlines()
    assert content[:5] == {"csv": content[:5], "dxf": b"  0\nS", "pdf": b"%PDF-"}[kind]
