"""Every command about every example, with every key swept or taken away, in both languages: a result or a sentence."""

import itertools
import random
import re

import pytest
from conftest import CONFIGS, PICKED, WANTED

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS
from afmcalc.cli.options import DRAWINGS
from afmcalc.spec.keys import keys

EXAMPLES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
NUMBERS = [key.path for key in keys().values() if key.unit]
TEXTS = [key.path for key in keys().values() if not key.unit]
SWEEPING = ["accuracy", "overload", "life", "simulate", "plot accuracy", "plot life"]
SHORT = ["--set", "drive.event.duration=0.002", "--set", "tolerance.samples=1000", "--set", "tolerance.sobol_base=64"]
REFUSED = {"en": "error: ", "ru": "ошибка: "}
WRONG = ['["stop"]', "{a = 1}", "1", "true", "x"]
pytestmark = pytest.mark.usefixtures("libraries")
ASKED = [
    *(name for name in COMMANDS if name in ANALYSES and ANALYSES[name].section and name not in SWEEPING),
    *("compare", "check", "solve accuracy_factor=2"), *(f"explain {name}" for name in EXPLAINED),
    *(f"plot {name}" for name, plot in PLOTS.items() if plot.takes in ("clutch", "clutches") and name not in ("accuracy", "life", *DRAWINGS)),
]  # fmt: skip


def cases():
    """Command lines: keys swept over their default range, keys without a value, text keys with a wrong one."""
    for example, language in itertools.product(EXAMPLES, REFUSED):
        spec = f"example:{example}"
        short = SHORT[:2] if example in {"drive", *PICKED} else SHORT[2:] if example == "tolerance" else []
        for command, key in itertools.product(SWEEPING, NUMBERS):
            yield [*command.split(), spec, "--sweep", key, *short], language
        for command in ASKED:
            yield [*command.split(), spec, *short], language
        for key in [*NUMBERS, *TEXTS]:
            yield ["check", spec, *short, "--set", f"{key}="], language
        for key, value in itertools.product(TEXTS, WRONG):
            yield ["check", spec, *short, "--set", f"{key}={value}"], language


@pytest.mark.parametrize("share", [4800, pytest.param(600, marks=pytest.mark.slow)])
def test_a_result_or_a_sentence(share, afmcalc, monkeypatch):
    """A share of all command lines, drawn with a seed, is run."""
    monkeypatch.setenv("COLUMNS", "80")
    asked = [*cases()]
    wrong = []
    for arguments, language in random.Random(3).sample(asked, len(asked) // share):
        monkeypatch.setenv("AFMCALC_LANG", language)
        run = afmcalc(*arguments)
        said = run.code in (0, 1) if arguments[0] == "check" else run.code == 0
        # a list of one's own that is not there is a file that cannot be read
        refused = run.code in ((2, 3) if "catalogues." in arguments[-1] else (2,)) and REFUSED[language] in run.err
        if not (said or refused) or "Traceback" in run.err or (language == "en" and broken_range(arguments, run)):
            wrong.append((run.code, language, " ".join(arguments), run.err[:300]))
    assert not wrong


def broken_range(arguments, run):
    """True if a default range breaks a rule of its key; that a layout needs more than a mean radius is not counted."""
    unlaid = "required beside [envelope]" in run.err
    return "--sweep" in arguments and not unlaid and re.search("sweep at|whole number", run.err)


@pytest.mark.parametrize(("key", "ends"), [
    # half to twice the present value: whole numbers of balls; ratios, radii and temperatures within their limits
    ("control_unit.balls", (3, 12)), ("friction.static_ratio", (1, 2.3)), ("heat.ambient", (173.15, 586.3)),
    ("friction_group.inner_radius", (0.04, 0.12)), ("friction_group.outer_radius", (0.08, 0.24)),
])  # fmt: skip
def test_a_range_nobody_gave_keeps_the_rules_of_its_key(key, ends, afmcalc):
    run = afmcalc("accuracy", "example:drive", "--sweep", key, "--json")
    values = run.json["result"]["sweep"][0]["values"]
    assert (values[0], values[-1]) == pytest.approx(ends, rel=1e-9)
    assert values == sorted(values)
