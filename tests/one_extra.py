"""Every command for every example in both languages, where one extra alone is installed, or none.

``python tests/one_extra.py NAME`` (or ``''``) with the Python of an environment that has only it. A command does what is asked, or
ends with 2 and a sentence; what is missing is named as pip knows it, and it is not what is there.
"""

import contextlib
import io
import os
import re
import sys
import tempfile
import time
from importlib.metadata import metadata

from afmcalc.analysis.registry import EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS, main
from afmcalc.spec.parse import example_names, example_text

WITHOUT_CLUTCH = (["design", "example:requirements"], ["plot", "pareto", "example:requirements"], ["reproduce"])
OTHERS = (
    "design",
    "handbook",
    "reproduce",
    "equations",
    "examples",
    "materials",
    "explain",
    "solve",
    "init",
    "plot",
    "schema",
    "serve",
)
SHORT = {"drive": "drive.event.duration=0.02", "tolerance": "tolerance.samples=2000"}
"""Example → a value with which it does not last."""


def command_lines():
    """Every command, most of them for each example."""
    yield from (
        *WITHOUT_CLUTCH,
        ["equations"],
        ["examples"],
        ["handbook", "-o", "h.html", "--force"],
        ["materials"],
    )
    yield from (["init", "a.toml", "--force"], ["schema"], *([name, "--help"] for name in COMMANDS))
    for name in example_names():
        if "[wanted]" in example_text(name) or name.endswith("-clutch"):  # the drive of a picked one takes its time
            continue
        given = [f"example:{name}", *(("--set", SHORT[name]) if name in SHORT else ())]
        yield from ([command, *given] for command in COMMANDS if command not in OTHERS)
        yield ["synthesize", *given, "-o", "b.toml", "--force"]
        yield ["solve", "accuracy_factor=1.2", *given]
        if name == "default":
            yield from (["explain", command, *given] for command in EXPLAINED)
        for plot in ("torque", "pocket") if name != "default" else PLOTS:
            if PLOTS[plot].takes == "clutch":
                yield from (["plot", plot, *given, "-o", f"c.{kind}", "--force"] for kind in ("svg", "dxf"))


def run(arguments):
    """Exit code of a command line, and what it says on standard error."""
    errors = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
        try:
            main(arguments)
        except SystemExit as end:
            return end.code, errors.getvalue()


def unserved(language):
    """What is wrong with how the page is refused where its extra is not installed; one sentence is right."""
    code, said = run(["serve", "--no-browser", "--lang", language])
    right = code == 2 and re.fullmatch(r"(error|ошибка): .*afmcalc\[web\].*", said.strip())
    return "" if right else f"serve: exit {code}: {said.strip()[-300:]}"


def fault(arguments, extra, known):
    """What is wrong with how a command line ends; nothing where it ends well."""
    code, said = run(arguments)
    missing = re.findall(r"afmcalc\[(.*?)\]", said)
    if code in (0, 1 if arguments[0] == "check" else 0) and not missing:
        return ""
    if code == 2 and re.search("^(error|ошибка): ", said, re.MULTILINE) and set(missing) <= known - {extra}:
        return ""
    return f"{' '.join(arguments)}: exit {code}: {said.strip()[-300:]}"


if __name__ == "__main__":
    (extra,) = sys.argv[1:]
    known = set(metadata("afmcalc").get_all("Provides-Extra"))
    os.chdir(tempfile.mkdtemp())
    begun = time.monotonic()
    lines = [[*line, "--lang", language] for line in command_lines() for language in ("en", "ru")]
    faults = [found for line in lines if (found := fault(line, extra, known))]
    if extra != "web":
        faults += [found for language in ("en", "ru") if (found := unserved(language))]
    print(
        f"{extra or 'none'}: {len(lines)} command lines, {len(faults)} faults, {time.monotonic() - begun:.0f} s",
        *faults,
        sep="\n  ",
    )
    sys.exit(bool(faults))
