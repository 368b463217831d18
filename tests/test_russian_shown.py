"""What is shown in Russian holds no English: every command for every example, plots, reports, helps; and nothing is said past the catalogue."""

import ast
import functools
import html
import itertools
import re
from collections.abc import Iterator
from urllib.parse import unquote

import pytest
from conftest import CONFIGS, PICKED, WANTED, several
from sources import FILES, nodes
from texts import texts

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.messages import language, speaking, translate
from afmcalc.papers import FIGURES
from afmcalc.papers.register import data, misprints
from afmcalc.render.symbols import native
from afmcalc.render.units import _IN_ENGLISH, worded
from afmcalc.variants import VARIANTS

EXAMPLES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
ALONE = ("design", "equations", "reproduce", "examples", "materials", "explain", "solve")
"""Commands that take no clutch, or more than one."""

COMMANDS = [
    *([name] for name, each in ANALYSES.items() if name not in ALONE),
    *(["explain", name] for name in EXPLAINED),
    *(["plot", name] for name, each in PLOTS.items() if each.takes in ("clutch", "clutches")),
    *(["accuracy", "--sweep", "C=0.2:1:3"], ["life", "--sweep", "dT"], ["overload", "--sweep", "z1"]),
    *(["compare", "--variants"], ["solve", "accuracy_factor=1.01"], ["springs", "--set", "closing_spring.room.length=1e-3"]),
    ["check", "--set", "requirements.peak_torque=1", "--set", "requirements.cycles=1e9", "--set", "C=3"],
]  # fmt: skip
WITHOUT_CLUTCH = [
    *(["design", "example:requirements"], ["design", "example:requirements", "--set", "accuracy_factor=1.0001"]),
    *(["reproduce"], ["equations"], ["equations", "--misprints"], ["examples"], ["materials"]),
    ["plot", "pareto", "example:requirements"],
    *(["plot", "paper", name] for name in FIGURES),
]
ERRORS = [
    *(["torque", "no.toml"], ["torque", "."], ["torqe"], ["torque", "--hepl"], ["torque", "--format", "xml"], ["solve"]),
    *(["torque", "--set", f"closing_spring.force={text}"] for text in ("2 mm", "5 J", "2 kNN", "-1", "0,5", "true")),
    *(["torque", "--set", text] for text in ("friction_group.gain=1", "friction.mux=1", "variant=foo", "friction.max=0.05", "variant=indirect")),
    *(["accuracy", "--sweep", "C=1:2"], ["plot", "foo"], ["explain", "foo"], ["equations", "--id", "X"]),
    *(["reproduce", "--figure", "S22-9"], ["springs", "--top", "0"], ["design"], ["torque", "-o", "a.pdf"]),
]  # fmt: skip

MISTAKES = [
    *(f"closing_spring.force={text}" for text in ("2 mm", "5 m/s^3", "2 kNN", "-1", "0,5", "true", "1e999", "nan", "[1]", "{a = 1}", "")),
    *(f"friction.{text}" for text in ("min=2", "min=0", "max=0.05", "max=0.5 N", "mux=1", "material=wod", "mean=9")),
    *(f"friction_group.{text}" for text in ("pairs=2.5", "pairs=0", "pairs=9000", "mean_radius=5 kg", "inner_radius=1", "size=1")),
    *(f"control_unit.{text}" for text in ("gain=-1", "gain=9", "gain=1 N", "wall_angle=100 deg", "wall_angle=45", "balls=0", "balls=400", "ball_diameter=1 m")),
    *("variant=foo", "variant=indirect", "adjustment.method=x", "adjustment.margin=0.5", "adjustment.nominal_torque=1 J"),
    *("drive.speed=5 1/s", "drive.event.kind=x", "fatigue.endurance_limit=1", "heat.ambient=-500", "tolerance.samples=0"),
    *("requirements.peak_torque=1", "requirements.machine_torque=x", "closing_spring=1", "nosuch.key=1"),
]  # fmt: skip
"""Values for --set that are wrong, or make a clutch that is no good."""

SHOWN = re.compile(
    r"^  *(\d+)? \| .*$"  # lines of a spec
    r"|^ *(Вызов: )?(afmcalc|export|eval|source)\b.*$|^ *--?\w.*?(?=  |$)|\\$"  # command lines, options
    r"|^SPEC .*$|\(Miner, .*?\)|\bconfigs/|умолчанию: \d\.\d|kNN|напишите \S+|: \w+\.\w+ = \S+|^.*[┤│].*$|\.\w{3}\b"  # curves, endings of files
    r"|\[[a-z][\w/-]*(?:, [\w.]+)?\]"  # codes of findings
    r"|'[^']*'|\"[^\"]*\"|\{[^}]*\}"
    r"|\b\w+(?:[.-][A-Za-z]\w*)+\b|--[\w-]+|\b\w*_\w*(?:[.,]\w+)*"  # keys, files, options, symbols
    r"|\bafmcalc \w+|\bexample:\S+|[\w.]+=\S*|\bDIN EN \d+ [ABC] \S+"
    r"|\b[A-Z]{2,}\b|\b(?:sin|cos|Markdown|Schema|SciPy|SymPy|SVG|Excel)\b",
    re.MULTILINE,
)
CODES = {
    *ANALYSES, *PLOTS, *VARIANTS, *EXAMPLES, *WANTED, "init", "plot", "report", "schema", "min", "max", "event", "kind", "wear", "bore",
    "calculation", "latin", "stop", "load", "amplitude", "goodman", "centrifugal", "material", "length", "mass", "variant", "search", "fixed",
    "weight", "disc", "any", "start", "count", "step", "pip", "install", "example", "one", "both", "auto", "exact", "pairs",
    "true", "clutch", "json", "csv", "table", "engineer", "requirements", "travel", "alpha", "beta", "friction", "exceedance", "simulate", "work", "gain", "temperature", "cycles", "diameters", "fatigue",
}  # fmt: skip
"""Commands, keys and their choices of one word, as a user writes them."""
BIBLIOGRAPHY = re.compile(
    r"Juvinall.*?(?=  |\)|\]|$)|Johnson, Contact Mechanics, 1985\)(?:, \(4\.\d+a?\))*|ch\. 18|\([a-z ]+\)"
    r"|Almen & László|Budynas & Nisbett",
    re.MULTILINE,
)


def english(shown: str) -> set[str]:
    """Words in Latin letters that are no names, and numbers with a decimal point."""
    bare = SHOWN.sub(" ", shown)
    words = set(re.findall(r"\b[A-Za-z]{3,}\b", bare)) - CODES
    return words | set(re.findall(r"(?<![\w.,:])\d+\.\d+(?![\w.])", bare))


@pytest.fixture
def russian(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "ru")


@pytest.mark.every(20)
@pytest.mark.parametrize("name", EXAMPLES)
def test_every_command_for_every_example(name, afmcalc, russian):
    for command, *given in COMMANDS:
        if "springs" in (command, *given) and name not in ("default", "indirect"):
            continue  # whatever the clutch, it is the same table
        # what simulate says is said once, of a motor soon at rest; the others need not follow the drive to its end
        light = {"simulate": "motor_inertia=0.1", "check": "event.duration=0.05", "heat": "event.duration=0.05"}
        short = [f"drive.{light[each]}" for each in (command, *given) if each in light and name in {"drive", *PICKED}]
        more = [*given, *(part for each in short[:1] for part in ("--set", each))]
        words = more[:1] if command in ("explain", "plot", "solve") else []
        run = afmcalc(command, *words, f"example:{name}", *more[len(words) :])
        assert run.code in (0, 1, 2), run.err
        assert not english(BIBLIOGRAPHY.sub("", run.out + run.err)), (command, *more)


ECHO = re.compile(r'[\w.]+ = [^:\n]+(?=: )|"[^"\n]*"|например \d[\d.]*|ключами [\w, ]+')
"""A value as it was given, one as it may be given, and lists of keys."""


def mistaken():
    """Every command about every example with one mistake; what is simulated is short."""
    for (command, *given), name, mistake in itertools.product(COMMANDS, EXAMPLES, MISTAKES):
        if "springs" in (command, *given) and name not in ("default", "indirect"):
            continue
        words = given[:1] if command in ("explain", "plot", "solve") else []
        short = ["--set", "drive.event.duration=0.002"] if name in {"drive", *PICKED} else []
        yield [command, *words, f"example:{name}", *given[len(words) :], *short, "--set", mistake]


def test_a_mistake_is_told_in_russian(afmcalc, russian):
    shown = {}
    for arguments in itertools.islice(mistaken(), 0, None, several(301, 1)):
        run = afmcalc(*arguments)
        if found := english(ECHO.sub(" ", BIBLIOGRAPHY.sub("", run.out + run.err))):
            shown[" ".join(arguments)] = found
    assert not shown


def test_every_other_command(afmcalc, russian):
    for command in WITHOUT_CLUTCH:
        run = afmcalc(*command)
        assert not english(BIBLIOGRAPHY.sub("", run.out) + run.err), command


NAMED = [
    *(["torque"], ["check"], ["explain", "torque"], ["report"], ["plot", "torque"], ["plot", "pocket", "--force", "-o", "pocket.svg"]),
    *(["compare", "--format", format_] for format_ in ("table", "csv", "markdown", "json")),
    *(["compare", "--variants"], ["accuracy", "--sweep", "C=0.1,0.2"]),
]  # fmt: skip
"""Commands that show the name of a clutch."""


@pytest.mark.parametrize("name", ["spec", "torque", "yes", "pairs", "closing spring"])
def test_a_name_of_the_user_stays_as_it_is(name, afmcalc, russian, undrawn, tmp_path, monkeypatch):
    """Whatever else it means: all that is shown is what is shown of a name that means nothing, but for the name."""
    monkeypatch.chdir(tmp_path)
    nothing = re.sub("[a-z]", "q", name)
    for command, *given in NAMED:
        words = given[:1] if command in ("explain", "plot") else []
        shown = []
        for each in (name, nothing):
            run = afmcalc(command, *words, "example:default", *given[len(words) :], "--set", f"name={each}")
            assert run.code == 0, run.err
            text = (tmp_path / given[-1]).read_text(encoding="utf-8") if "-o" in given else run.out
            shown.append(unquote(html.unescape(text)).replace(r"\20 ", " "))
        said, unsaid = shown
        assert name in said, (command, *given)
        assert said == unsaid.replace(nothing, name), (command, *given)


@pytest.mark.parametrize("command", ERRORS, ids=" ".join)
def test_errors(command, afmcalc, russian):
    run = afmcalc(*command)
    assert run.code in (2, 3)
    assert "ошибка: " in run.err
    assert not english(run.err)


def test_every_help(afmcalc, russian):
    for command in ("", *ANALYSES, "init", "plot", "report", "schema"):
        run = afmcalc(*[command][: bool(command)], "--help")
        assert run.code == 0
        assert not english(re.sub(r"(?m)^  \w+  |(?<=  )\w+, |^ +[\w.]+=.*$", " ", run.out)), command


REPORTS = {
    "drive": "drive.event.duration=0.05",
    "tolerance": "tolerance.samples=1000",
    "constant-torque": "report.date=2026-11-21",
}


@pytest.fixture(scope="module")
def page_of(afmcalc):
    @functools.cache
    def page(name):
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("AFMCALC_LANG", "ru")
            return afmcalc("report", f"example:{name}", "--set", REPORTS[name]).out

    return page


@pytest.mark.every(20)
@pytest.mark.parametrize("name", REPORTS)
def test_report(name, page_of):
    # books stand in the list in their own language
    page = re.sub(r'(?s)<dl class="references">.*?</dl>', " ", page_of(name))
    for code in ("style", "pre", "code", "math", "sub"):
        page = re.sub(rf"(?s)<{code}\b.*?</{code}>", " ", page)
    page = re.sub(r"<tspan[^>]*font-size[^>]*>", "_", page.replace("</tspan>", ""))
    shown = re.sub(r'(?s)<meta[^>]*>|<[^>]*?aria-label="([^"]*)"[^>]*>', r" \1 ", html.unescape(page))
    shown = re.sub(r"<[^>]*>|\[drive\]|\bSHA-256|afmcalc [\d.]+", " ", shown)
    headings = re.compile(r"(?<=\s)\d\.\d+(?=\s)|(?<=\()\d\.\d+[a-z]?(?=\))|--set .*")  # and formulas of a book
    assert not english(headings.sub(" ", BIBLIOGRAPHY.sub(" ", shown))) - {"afmcalc"}


@pytest.mark.exhaustive
def test_the_report_has_the_form_of_a_calculation(page_of):
    page = page_of("constant-torque")
    sections = re.findall(r'<h2><span class="count">\d+</span> ([^<]*)</h2>', page)
    first = ["Задание", "Исходные данные", "Условия и проверки", "Расчёт", "Выводы"]
    assert sections == [*first, "Список обозначений", "Список использованных источников"]
    assert re.findall(r"<dt>([^<]*)</dt>", page)[:1] == ["Обозначение"]
    for entry in ("Разработал", "Проверил", "Н. контр.", "Утв."):
        assert f'<th scope="row">{entry}</th>' in page
    assert "<dt>Дата</dt><dd>21.11.2026</dd>" in page
    assert 'lang="ru"' in page
    numbers = "".join(re.findall(r"<mn>([^<]*)</mn>", page))
    assert "," in numbers
    assert "." not in numbers
    # an index is no unit: τ_m is not τ_м
    assert re.search(r"<mtext>m</mtext></mrow></msub>", page_of("tolerance"))
    assert "<mtext>МПа</mtext>" in page or "<mtext>Па</mtext>" in page


NO_SENTENCE = (
    "module {} has", "--format ", "<{} clutch of", "afmcalc ", "friction.driving + ",  # for programs and names
    "Input should be", "Value error, ", "Cannot overwrite",  # what libraries say
    "bold red", "upper left", "offset points", "Glyph|constrained", "<div class=",  # what they take
    "ordinary friction safety", "Werner's clutch", "all torque passes", "the release force moves",  # of the API
    "{count} driving pairs", "Carslaw", "Finkin", "DIN EN ", "EN 13906-1", "N kN MN", "mm cm m", "deg rad", "MPa kPa",
    "rpm rad", "a b v g d", "import sys;", "default-src", "{} font-family",
)  # fmt: skip
"""How the texts begin that are not for people to read, or are in no language."""


def test_nothing_is_said_past_the_catalogue():
    """No sentence is a plain text, a filled-in f-string, or glued together of sentences."""
    known = {text for _, text in texts()} | {*_IN_ENGLISH.values()}  # of names; Russian has the names themselves
    found = []
    for module in FILES:
        room = module.partition(".")[0]
        if room == "equations":
            continue
        found += [f"{module}: {text}" for text in _sentences(nodes(module)) if not _is_known(text, known)]
        found += [f"{module}: {ast.unparse(node)}" for node in nodes(module) if _glues(node) and room != "render"]
    assert not found


def _sentences(everything: tuple[ast.AST, ...]) -> Iterator[str]:
    """Texts of several words, docstrings and annotations left out; a value in an f-string is ``{}``."""
    apart: set[ast.AST] = set()
    for node in everything:
        body = getattr(node, "body", None)
        apart |= {each.value for each in body if isinstance(each, ast.Expr)} if isinstance(body, list) else set()
        for part in (getattr(node, "annotation", None), getattr(node, "returns", None)):
            apart |= set(ast.walk(part)) if part else set()
        apart |= set(node.values) if isinstance(node, ast.JoinedStr) else set()
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "namedtuple":
            apart |= set(node.args)  # names of fields
    for node in everything:
        parts = node.values if isinstance(node, ast.JoinedStr) else [node]
        if node in apart or not (isinstance(node, ast.JoinedStr) or isinstance(getattr(node, "value", 0), str)):
            continue
        text = "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in parts)
        words = re.search(r"\b[A-Za-z]{3,},? \W*(?:[a-z]{2,}|\{\})\b|\{\} [a-z]{3,}\b|\b[a-z]{3,} \{\}", text)
        if words and not re.search(r"</|/>|<\?|xmlns|role=|\\[(SbsdDw]|<\{\} style", text):
            yield text


def _is_known(text: str, known: set[str]) -> bool:
    if text in known or text.startswith(NO_SENTENCE):
        return True
    pattern = re.compile(".+".join(map(re.escape, text.split("{}"))))
    return "{}" in text and any(pattern.fullmatch(each) for each in known)


def _glues(node: ast.AST) -> bool:
    """Whether sentences are set together to a text that forgets what it was made of."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "join":
        inside: list[ast.AST] = [*node.args, node.func.value]
    elif isinstance(node, ast.JoinedStr):
        inside = [*node.values]
    else:
        return False
    calls = (each for part in inside for each in ast.walk(part) if isinstance(each, ast.Call))
    return any(isinstance(each.func, ast.Name) and each.func.id in ("say", "say_many", "term") for each in calls)


@pytest.mark.parametrize("encoding", ["ascii", "cp1251", "koi8-r"])
def test_streams_that_have_not_all_letters(encoding, afmcalc, russian):
    """Tables, helps and errors are spelled in what there is; a spec is UTF-8, so that it can be read again."""
    for arguments in (["explain", "torque", "example:indirect"], ["torque", "--help"], ["plot", "life"], ["solve"]):
        run = afmcalc(*arguments, encoding=encoding)
        assert run.code in (0, 2)
        assert "\\u" not in run.out + run.err
    spec = afmcalc("init", "-", encoding=encoding).out
    assert spec == afmcalc("init", "-").out
    assert afmcalc("torque", "-", stdin=spec).code == 0


def test_what_s22_prints_keeps_its_symbol_and_all_else_has_another(russian):
    """T_ср is in S22 the torque at actuation, in S19 that at mean friction; here the former is T_сраб."""
    with speaking(language("ru")):
        of_s22 = [each for each in misprints() if each.where.startswith("S22")]
        printed = [native(f"«{translate(each.printed)}»") for each in of_s22]
        ours = [translate(text or "") for each in of_s22 for text in (each.correct, each.why, each.reading)]
        claims = [claim for claim in data("claims.toml")["claim"] if "S22" in claim["source"]]
        ours += [worded(claim.get(part, "")) for claim in claims for part in ("why", "inputs", "correction")]
        printed += [worded(claim["printed"]) for claim in claims]
    assert "T_ср" in str(printed)
    assert "T_сраб" not in str(printed)
    assert "T_сраб" in str(ours)
    assert not [text for text in ours if re.search(r"T_ср\b", re.sub("«[^»]*»", "", text))]
