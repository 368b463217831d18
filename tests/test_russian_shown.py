"""What is shown in Russian holds no English: commands, plots, reports, helps, errors."""

import html
import itertools
import re
from urllib.parse import unquote

import pytest
from babel.messages.pofile import read_po

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS
from afmcalc.messages import FOLDER, language
from afmcalc.papers import FIGURES

SHORT = ["--set", "drive.event.duration=0.02"]
ABOUT = [
    ["torque"],
    ["accuracy"],
    ["adjust"],
    ["overload"],
    ["synthesize"],
    ["life"],
    ["check"],
    ["compare"],
    ["layout"],
]
MISTAKES = [
    *(f"closing_spring.force={text}" for text in ("2 mm", "5 m/s^3", "2 kNN", "-1", "0,5", "true", "1e999", "nan", "[1]", "{a = 1}", "")),
    *(f"friction.{text}" for text in ("min=2", "min=0", "max=0.05", "max=0.5 N", "mux=1", "material=wod", "mean=9")),
    *(f"friction_group.{text}" for text in ("pairs=2.5", "pairs=0", "mean_radius=5 kg", "inner_radius=1", "size=1")),
    *(f"control_unit.{text}" for text in ("gain=-1", "gain=9", "wall_angle=100 deg", "wall_angle=45", "balls=0", "ball_diameter=1 m")),
    *("variant=foo", "variant=indirect", "adjustment.method=x", "adjustment.margin=0.5", "adjustment.nominal_torque=1 J"),
    *("drive.speed=5 1/s", "drive.event.kind=x", "heat.ambient=-500", "tolerance.samples=0", "closing_spring=1", "nosuch.key=1"),
]  # fmt: skip
ARGUMENTS = [
    *("torque no.toml", "torque .", "torqe", "torque --hepl", "torque --format xml", "solve", "accuracy --sweep C=1:2", "plot foo", "design"),
    *("explain foo", "equations --id X", "reproduce --figure S22-9", "springs --top 0", "torque -o a.pdf", "torque example:defualt"),
]  # fmt: skip
WALK = {
    "law": [[*each, f"example:{name}"] for name in ("default", "indirect") for each in ABOUT],
    "drive": [[each, "example:drive", *SHORT] for each in ("simulate", "life")],
    "effects": [["effects", "example:drive", *SHORT]],
    "searches": [["springs", "example:conventional", "--kind", "disc"], ["tolerance", "example:tolerance", "--set", "tolerance.samples=1000"],
                 ["compare", "--variants"], ["accuracy", "--sweep", "C=0.2:1:3"], ["solve", "accuracy_factor=1.01"],
                 ["check", "--set", "requirements.peak_torque=1", "--set", "requirements.cycles=1e9", "--set", "C=3"]],
    "papers": [["equations"], ["equations", "--misprints"], ["reproduce"], ["examples"], ["materials"]],
    "steps": [["explain", name, f"example:{example}"] for name, example in zip(EXPLAINED, itertools.cycle(("default", "indirect")))]
    + [["explain", "torque", "example:default", "--format", "markdown"], ["accuracy", "--format", "markdown", "--sweep", "C=0,1"]],
    "plots": [["plot", name, "example:default"] for name, each in PLOTS.items() if each.takes == "clutch" and name != "springs"],
    "figures": [["plot", "paper", name] for name in FIGURES],
    "help": [["--help"], *([name, "--help"] for name in COMMANDS)],
    "spec": [*(["init", "-", "--kind", kind] for kind in ("clutch", "tolerance", "drive")), *(["schema", name] for name in ANALYSES)],
    "mistakes": [["check", "--set", each] for each in MISTAKES] + [each.split() for each in ARGUMENTS],
    "report": [["report", "example:conventional"]],
}  # fmt: skip
SLOW = {"design": [["design", "example:requirements"], ["springs", "example:indirect"]],
        "report of a drive": [["report", "example:drive", *SHORT], ["heat", "example:drive", *SHORT]]}  # fmt: skip

PROSE = re.compile(r"[a-z]{3,}[,;:]? [a-z]{3,}|^[A-Z][a-z]+$")
UNIT = re.compile("^(mm|kN|MPa|kJ|kg|rpm)$|^[A-Za-z]*([·/²³⁻¹]+[A-Za-z]*)+$")
ENGLISH = re.compile(r"\b(?:the|is|are|must|has|not|with|which|than|from|unknown)\b (?!=)")
"""Words that no Russian text has."""


class Noting:
    """A catalogue that keeps what it is asked for."""

    def __init__(self, whole) -> None:
        self.whole, self.asked = whole, set()

    def gettext(self, text):
        self.asked.add(("", text))
        return self.whole.gettext(text)

    def pgettext(self, context, text):
        self.asked.add((context, text))
        return self.whole.pgettext(context, text)

    def ngettext(self, one, many, count):
        self.asked.add(("", one))
        return self.whole.ngettext(one, many, count)


@pytest.fixture(scope="module")
def known():
    """English texts of the catalogue."""
    with open(f"{FOLDER}/ru.po", "rb") as file:
        return {each.id if isinstance(each.id, str) else each.id[0] for each in read_po(file) if each.id}


@pytest.fixture(scope="module", autouse=True)
def _libraries(afmcalc):
    """What draws and derives is imported before the time of a test runs."""
    afmcalc("plot", "torque")
    afmcalc("explain", "torque")


@pytest.fixture
def noting(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "ru")
    noting = Noting(language("ru").catalogue)
    monkeypatch.setattr(language("ru"), "catalogue", noting)
    return noting


def shown_by(run) -> str:
    """What people read of an output: no styles, no markup, no quotations, no bibliography."""
    text = re.sub(r"(?s)<(style|pre|code|math|script)\b.*?</\1>|<dl class=.references.*?</dl>", " ", run.out + run.err)
    return re.sub(
        r"(?m)<[^>]*>|^.*(?:Juvinall| // |EN 13906).*$|^ *\d* \| .*$|'[^']*'|\"[^\"]*\"", " ", html.unescape(text)
    )


@pytest.mark.parametrize("part", [*WALK, *(pytest.param(each, marks=pytest.mark.slow) for each in SLOW)])
def test_nothing_that_is_shown_is_english(part, known, noting, afmcalc, undrawn):
    """All that is looked up is there, and what is shown has no English words and no text as the catalogue has it."""
    sentences = [text for text in known if PROSE.search(text) and "{" not in text and len(text) > 17]
    wrong = []
    for command in (WALK | SLOW)[part]:
        noting.asked.clear()
        run = afmcalc(*command)
        assert run.code in (0, 1, 2, 3), run.err
        lacking = {
            text
            for context, text in noting.asked
            if text not in known and (PROSE, UNIT)[context == "unit"].search(text)
        }
        shown = shown_by(run)
        english = [line for line in shown.splitlines() if ENGLISH.search(line)] + [
            text for text in sentences if text in shown
        ]
        english += [text for text in lacking if not text.startswith(("\b", "Juvinall"))]
        wrong += [(command, text) for text in english]
    assert not wrong
    if part == "report":
        assert all(
            f'<th scope="row">{entry}</th>' in run.out for entry in ("Разработал", "Проверил", "Н. контр.", "Утв.")
        )


NAMED = [
    *("torque", "check", "explain torque", "report", "plot torque", "plot pocket --force -o pocket.svg", "compare --variants"),
    *(f"compare --format {each}" for each in ("csv", "markdown", "json")),
]  # fmt: skip
"""Commands that show the name of a clutch."""


@pytest.mark.parametrize("line", NAMED)
def test_a_name_of_the_user_stays_as_it_is(line, afmcalc, undrawn, tmp_path, monkeypatch):
    """Whatever else it means: all that is shown is what is shown of a name that means nothing, but for the name."""
    monkeypatch.setenv("AFMCALC_LANG", "ru")
    monkeypatch.chdir(tmp_path)
    shown = []
    for name in ("closing spring", "qqqqqqq qqqqqq"):
        run = afmcalc(*line.split(), "--set", f"name={name}")
        assert run.code == 0, run.err
        text = (tmp_path / "pocket.svg").read_text(encoding="utf-8") if "-o" in line else run.out
        shown.append(unquote(html.unescape(text)).replace(r"\20 ", " "))
    assert "closing spring" in shown[0]
    assert shown[0] == shown[1].replace("qqqqqqq qqqqqq", "closing spring")


@pytest.mark.parametrize("encoding", ["ascii", "cp1251", "koi8-r"])
def test_streams_that_have_not_all_letters(encoding, afmcalc, monkeypatch):
    """Tables, helps and errors are spelled in what there is; a spec is UTF-8, so that it can be read again."""
    monkeypatch.setenv("AFMCALC_LANG", "ru")
    for arguments in (["explain", "torque", "example:indirect"], ["torque", "--help"], ["plot", "life"], ["solve"]):
        run = afmcalc(*arguments, encoding=encoding)
        assert run.code in (0, 2)
        assert "\\u" not in run.out + run.err
    assert afmcalc("init", "-", encoding=encoding).out == afmcalc("init", "-").out
