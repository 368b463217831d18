"""The page says what the command line says: numbers, sentences, commands; its form has every key but those of files."""

import json
import math
import random
import re
import shlex
import tomllib
from html import unescape

import pytest
from conftest import CONFIGS, slow
from pages import Here, Site, cells, is_shown, sets, spec_in, tags, web
from sources import REFUSED

from afmcalc.spec.keys import keys

pytestmark = web
VARIANTS = ["conventional", "all-driving", "unlike-materials", "envelope", "constant-torque"]


@pytest.fixture(scope="module")
def sites(afmcalc, tmp_path_factory):
    """The page of each shipped example, made once."""
    made = {}

    def site(name):
        if name not in made:
            spec = spec_in(tmp_path_factory.mktemp(name), name)
            made[name] = spec, Site(afmcalc, spec)
        return made[name]

    return site


def numbers(spec, path=""):
    """Key → text of every number in a spec, as the file has it."""
    found = {}
    for name, value in spec.items():
        key = f"{path}.{name}" if path else name
        if isinstance(value, dict):
            found |= numbers(value, key)
        elif not isinstance(value, bool | list) and str(value)[:1].isdigit():
            found[key] = str(value)
    return found


def changed(text, by):
    """Text of a quantity multiplied by ``by``, in the same unit."""
    number, _, unit = text.partition(" ")
    size = round(int(number) * by) if number.isdecimal() and not unit else float(f"{float(number) * by:.4g}")
    return f"{size} {unit}".strip()


def state(draw, given):
    """Fields of a form: one to four numbers, a little larger or smaller; sometimes one of several in a table empty."""
    some = draw.sample(sorted(given), min(4, len(given)))[: draw.randint(1, 4)]
    fields = {key: changed(given[key], draw.uniform(0.85, 1.15)) for key in some}
    # the form removes a table with its last key, which --set KEY= alone does not do
    alone = sum(other.rpartition(".")[0] == some[0].rpartition(".")[0] for other in given) == 1
    if draw.random() < 0.3 and not alone:
        fields[some[0]] = ""
    return {key: text for key, text in fields.items() if text != given[key]}


def agree(answer, spec, fields, afmcalc):
    """The numbers of an answer are those of the command's JSON, or its sentences those of its errors."""
    run = afmcalc("torque", spec, *sets(fields), "--json")
    if run.code == 0:
        assert not answer.get("errors")
        assert not answer.get("problems")
        is_shown(cells(answer["fragments"]["numbers"]), run.json["result"])
        if fields:
            assert [part for part in shlex.split(answer["command"]) if "=" in part] == sets(fields)[1::2]
        assert afmcalc(*shlex.split(answer["command"])[1:], "--json").json == run.json
        return 1
    assert "fragments" not in answer
    lines = [line.removeprefix("error: ") for line in run.err.splitlines() if line.startswith("error: ")]
    told = [*answer["errors"].values(), *answer["problems"]]
    for line in lines:
        key, said = re.fullmatch(r"[^ ]+: ([\w.]+)(?: = .*?)?: (.*)", line).groups()
        assert key in answer["errors"] or said in " ".join(told), (line, answer)
    assert lines
    assert all(any(line.endswith(text) for line in lines) for text in told)
    return 0


@pytest.mark.parametrize("count", [1, *slow(6)])
@pytest.mark.parametrize("name", ["default", "indirect", *slow(*VARIANTS)])
def test_any_state_is_what_the_command_line_says(sites, afmcalc, name, count):
    """The page has the numbers or the errors of the command line, and shows the command that gives them."""
    spec, site = sites(name)
    given, draw = numbers(tomllib.loads(spec.read_text(encoding="utf-8"))), random.Random(name)
    fine = agree(site.live({}), spec, {}, afmcalc)
    for _ in range(count):
        fields = state(draw, given)
        fine += agree(site.live(fields), spec, fields, afmcalc)
    assert fine > count / 2


HOSTILE = ["\0", "\ud800", "[" * 9000, "{a=" * 9000, "9" * 60_000, "{{7*7}}{% raw %}", "</title><svg onload=alert(1)>"]


def test_errors_are_those_of_the_command_line(sites, afmcalc):
    spec, site = sites("default")
    for key, text in REFUSED["edited"]:
        assert agree(site.live({key: text}), spec, {key: text}, afmcalc) == 0, (key, text)


def test_an_error_stands_at_its_field(sites):
    """Every wrong field has its error, also a missing table or key; errors of a pinned state are not shown."""
    _, site = sites("default")
    for text in HOSTILE:
        told = site.live({"control_unit.gain": text})
        assert told.keys() == {"errors", "problems"}
        assert told["problems"] or told["errors"].keys() == {"control_unit.gain"}
    fields = {"control_unit.gain": "x", "friction.max": "y", "friction.min": ""}
    assert site.live(fields)["errors"].keys() == fields.keys()
    assert site.live({"variant": "indirect"})["errors"].keys() >= {"control_unit.key_friction", "control_spring"}
    pinned = {"base": 0, "fields": {"control_unit.gain": "x"}}
    assert site.live({}, pinned=pinned)["fragments"]["numbers"] == site.live({})["fragments"]["numbers"]


FILES = [
    "catalogues.materials", "catalogues", " catalogues.discs", "catalogues .balls", '"catalogues".materials',
    "tolerance.fields", 'tolerance.fields."control_unit.gain".spread', "control_unit.gain=0.5\ncatalogues.materials",
    "control_unit.gian", "nothing.x", "name.x", "", "=", "__class__", "name.__class__", "a." * 9000, "\ud800",
]  # fmt: skip
"""Names that are not keys of the form: they name files, hold tables, or do not exist."""


def test_no_key_of_a_form_names_a_file(site, tmp_path):
    """The answer is the same for an existing file, a missing one, and one that never ends; nothing is saved."""
    (tmp_path / "there").write_text("secret = 4711 4711", encoding="utf-8")
    for key in FILES:
        for file in (tmp_path / "there", tmp_path / "gone", "/dev/zero", '{materials = "/dev/zero"}'):
            fields = {key: str(file)}
            told = site.live(fields)
            assert (told["errors"], told.keys()) == ({}, {"errors", "problems"}), key
            assert told["problems"]
            assert site.tab("accuracy", fields) == told == site.post("save", {"base": 0, "fields": fields}).json
            assert str(file) not in str(told)
    for file in (tmp_path / "there", tmp_path / "gone", "/dev/zero"):
        asking = f'[catalogues]\nmaterials = "{file}"\n'
        assert site.tab("design", {}, requirements=asking)["errors"]["requirements"].startswith("catalogues: only")


def test_a_form_has_every_key_that_names_no_file(sites):
    """Each field has the number of the file in the unit shown at the field; sliders keep to the limits of the key."""
    from afmcalc.web.entered import as_spec

    def read(key, text):
        return keys()[key].about.read(int(text) if keys()[key].about.whole else as_spec(keys()[key], text))

    for name in ("default", "indirect"):
        spec, site = sites(name)
        form = site.post("open", {"base": 0}).json["html"]
        named, given = tags(form, "name"), numbers(tomllib.loads(spec.read_text(encoding="utf-8")))
        files = ("catalogues.", "tolerance.fields")
        assert named.keys() == {key.path for key in keys().values() if not key.path.startswith(files)}
        for key, text in given.items():
            assert read(key, named[key]["value"]) == pytest.approx(read(key, text), rel=1e-9), key
        for key, slider in tags(form, "data-of").items():
            for end_of, way in (("least", 1), ("most", -1)):
                end, step = float(slider[f"data-{end_of}"]), way * (1 if "data-whole" in slider else 1e-6)
                if math.isfinite(end):
                    read(key, f"{end + step:.9g}")
                    with pytest.raises(ValueError):  # noqa: PT011
                        read(key, f"{end - step:.9g}")


def test_empty_is_absent(sites, afmcalc):
    """An empty field removes its key, and its table if nothing else is left in it."""
    spec, site = sites("default")
    assert agree(site.live({"friction.mean": ""}), spec, {"friction.mean": ""}, afmcalc)
    told = site.live({"drive.dynamic_factor": ""})
    assert "--set drive=" in told["command"]
    assert cells(told["fragments"]["numbers"]) == cells(site.live({})["fragments"]["numbers"])
    assert "--set" not in site.live({"friction_group.inner_radius": " "})["command"], "it is not given"


def test_the_end_of_a_text_in_a_command_is_none_of_its_lines():
    from afmcalc.web.form import Base, State

    text = f'{(CONFIGS / "default.toml").read_text(encoding="utf-8")}[report]\nproject = """\\\nSPEC\nSPEC_\n"""\n'
    assert State(Base("text", text, "-")).command("torque").endswith("\nSPEC__")


def test_a_text_is_quoted_and_escaped(site, afmcalc):
    """A text is quoted for the shell in the command, and escaped for HTML on the page, as a name, a value or a key."""
    name = 'it\'s $HOME; "x" `y` </title><script>alert(1)</script> {{7*7}}'
    told = site.live({"name": name})
    run = afmcalc(*shlex.split(told["command"])[1:], "--json")
    assert run.json["spec"]["name"] == name
    is_shown(cells(told["fragments"]["numbers"]), run.json["result"])
    page = Site(afmcalc, "--set", f"name={name}").get().body.decode()
    for html in (*told["fragments"].values(), page):
        assert "<script>alert" not in html
    assert "it&#39;s $HOME; &#34;x&#34; `y` &lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt; {{7*7}}" in page


def test_compared_with_what_is_pinned(site):
    """The numbers of the pinned clutch stand beside those of the state, which stay the same."""
    now, before = {"control_unit.gain": "0.8"}, {"control_unit.gain": "0.4"}
    alone, was = site.live(now)["fragments"], site.live(before)["fragments"]
    pinned = site.live(now, pinned={"base": 0, "fields": before})["fragments"]
    assert cells(alone["numbers"]) == cells(pinned["numbers"])
    (shown, *_) = re.findall(r'data-path="accuracy_factor"[^>]*>([^<]+)<', was["numbers"])
    assert [shown in each["numbers"] for each in (pinned, alone)] == [True, False]
    assert alone["compare"] == ""
    assert re.findall(r'<td class="number(?: soft)?">([^<]*)<', pinned["compare"]) == ["0.8", "0.4"]  # now, pinned
    for name in ("section", "torque"):
        assert alone[name] != was[name]
        assert not re.search(r"<script|https?://(?!www\.w3\.org/)", alone[name])


@pytest.mark.parametrize("name", ["default", "drive"])
def test_the_verdict_is_that_of_check(sites, afmcalc, name):
    """The verdict comes at once if nothing takes long; else first a verdict so far, which says that it is not final."""
    spec, site = sites(name)
    fields = SHORT if name == "drive" else {}
    verdict = afmcalc("check", spec, *sets(fields), "--json").json["result"]["verdict"]
    at_once, whole = site.live(fields), site.tab("check", fields)
    said = letters(verdict["sentence"])
    assert said in letters(whole["html"])
    assert at_once["judging"] == (name == "drive") == ("Calculating…" in at_once["fragments"]["verdict"])
    assert at_once["judging"] != (said in letters(at_once["fragments"]["verdict"]))
    assert at_once["judging"] or at_once["fragments"]["verdict"] == whole["html"]
    assert shlex.split(whole["command"])[:3] == ["afmcalc", "check", str(spec)]


def letters(text):
    """Letters and digits of a text or a page, without the markup."""
    return re.sub(r"[\W_]+", "", unescape(re.sub("<[^>]*>", "", text)))


LACKS = {"drive": "drive", "heat": "drive", "tolerance": "tolerance"}
"""Tab → block of a spec that it needs and the base clutch lacks."""
SHORT = {"drive.event.duration": "0.005 s"}


@pytest.mark.parametrize("name", ["accuracy", "drive", "heat", *slow("tolerance", "report")])
def test_each_tab_answers(sites, undrawn, name):
    """If the spec lacks the block of a tab, a sentence names it; else the tab shows the command of its table."""
    if name in LACKS:
        told = sites("default")[1].tab(name, {})
        assert LACKS[name] in str([*told["errors"], *told["problems"]])
        assert "html" not in told
    spec, site = sites(LACKS.get(name, "default"))
    fields = {"control_unit.gain": "0.7"} | (SHORT if name in ("drive", "heat") else {})
    fields |= {"tolerance.samples": "1000", "tolerance.sobol_base": "64"} if name == "tolerance" else {}
    answer = site.tab(name, fields)
    assert len(answer["html"]) > 1000
    command = {"drive": "simulate"}.get(name, name)
    assert shlex.split(answer["command"])[:3] == ["afmcalc", command, str(spec)]
    assert site.tab(name, {"control_unit.gain": "x"})["errors"].keys() == {"control_unit.gain"}


def charts(html):
    """Data of each chart in a fragment, which the script of the page draws."""
    return [json.loads(chart) for chart in tags(html, "data-chart")]


def test_the_curve_is_the_plots_with_the_pinned_state_beside_it(sites):
    """By F11 (12) with eight pairs, one of them bypass, C = 0.5, 2 kN, 100 mm; the curve of a pinned gain is paler."""

    def torque(f, gain):
        return 200 * 8 * f / (1 + gain * 7 * f)

    _, site = sites("default")
    (alone,) = charts(site.live({})["fragments"]["torque"])
    pinned = {"base": 0, "fields": {"control_unit.gain": "0.9"}}
    (both,) = charts(site.live({}, pinned=pinned)["fragments"]["torque"])
    assert [line["paler"] for line in both["lines"]] == [False, False, True, True]
    assert both["lines"][:2] == alone["lines"]
    for line, gain in ((both["lines"][0], 0.5), (both["lines"][2], 0.9)):
        assert line["y"] == pytest.approx([torque(x, gain) for x in line["x"]])
    assert (alone["x"]["ends"], alone["y"]["ends"][0]) == ([0.1, 0.8], 0)


def test_a_tab_has_options(sites):
    _, site = sites("default")
    swept = site.tab("accuracy", {}, sweep=" C=0:1:3 ")
    assert (swept["command"].endswith("--sweep C=0:1:3"), swept["html"].count("data-chart=")) == (True, 1)
    for name, option, text in (
        ("accuracy", "sweep", "nonsense=1:2"), ("accuracy", "sweep", "C=0:1:2000000000"), ("design", "requirements", "[search"),
    ):  # fmt: skip
        assert site.tab(name, {}, **{option: text})["errors"].keys() == {option}


FEW = """objectives = ["closing_force", "accuracy_factor"]
search = {"control_unit.gain" = [0.5, 0.7], "friction_group.pairs" = [8, 10], "adjustment.nominal_torque" = "200 N*m"}
"""


def test_a_point_of_the_front_loads(afmcalc, tmp_path):
    """The button of a point names a base state, whose numbers are those of the clutch that --pick writes."""
    site = Site(afmcalc, spec_in(tmp_path))
    before = site.live({})
    front = site.tab("design", {}, requirements=FEW)
    bases = [int(number) for number in tags(front["html"], "data-base")]
    assert bases == [*range(1, 1 + len(bases))]
    assert bases
    (tmp_path / "wanted.toml").write_text(
        FEW + (tmp_path / "clutch.toml").read_text(encoding="utf-8"), encoding="utf-8"
    )
    for number, base in enumerate(bases, 1):
        live = site.live({}, base=base)
        if number == len(bases):
            picked = tmp_path / "picked.toml"
            assert afmcalc("design", tmp_path / "wanted.toml", "--pick", number, "--save", picked).code == 0
            is_shown(cells(live["fragments"]["numbers"]), afmcalc("torque", picked, "--json").json["result"])
        shell, _, text = live["command"].partition("\n")
        assert shell == "afmcalc torque - <<'SPEC'"
        assert afmcalc("torque", "-", stdin=text.removesuffix("\nSPEC")).code == 0
        assert f'value="{base}"' in site.get(f"?base={base}").body.decode()
    assert site.post("live", {"base": bases[-1] + 1, "fields": {}}).status == 404
    assert site.live({})["fragments"] == before["fragments"]


@pytest.mark.slow
def test_of_the_bases_two_hundred_are_kept(afmcalc, tmp_path, monkeypatch):
    """The last ones that were looked at are kept, and always the clutch of the command line."""
    site = Site(afmcalc, spec_in(tmp_path))

    async def ask(self, job, gone, page):
        yield {"fragments": {}} if job["name"] == "live" else {"html": "", "bases": [["one", "", "-", [], ""]] * 90}

    def known():
        asked = [site.post("live", {"base": base, "fields": {}}).status for base in range(300)]
        return [base for base, status in enumerate(asked) if status == 200]

    monkeypatch.setattr(Here, "ask", ask)
    for numbers in (
        [],
        [*range(1, 91)],
        [*range(1, 91), *range(101, 191)],
        [*range(72, 91), *range(101, 191), *range(201, 291)],
    ):
        assert known() == [0, *numbers]
        assert "bases" not in site.tab("design", {})


def test_the_options_of_the_command_line_are_taken(afmcalc, tmp_path):
    """Values of --set on the command line are part of the clutch, the page and the command."""
    spec, fields = spec_in(tmp_path), {"closing_spring.force": "3 kN"}
    site = Site(afmcalc, spec, "--set", "control_unit.gain=0.9", "--lang", "ru", "--units", "si")
    assert 'lang="ru"' in site.get().body.decode()
    answer, asked = site.live(fields), sets({"control_unit.gain": "0.9", **fields})
    is_shown(cells(answer["fragments"]["numbers"]), afmcalc("torque", spec, *asked, "--json").json["result"])
    assert shlex.split(answer["command"])[3:] == asked
    assert ">3000<" in answer["fragments"]["numbers"]
    assert re.search("[а-я]{4}", site.live({"control_unit.gain": "x"})["errors"]["control_unit.gain"])
