"""What a command says where one extra alone is installed, or none: its result, or a sentence that names what is missing.

``python tests/one_extra.py NAME`` (or ``''``) with the Python of an environment that has only it.
"""

import contextlib
import io
import os
import re
import sys
import tempfile

from afmcalc.cli.main import main

DRAWS = {"plot", "report", "web"}
ASKED = {
    "torque": None,
    "plot torque": None,
    "plot torque -o a.svg": DRAWS,
    "plot pareto example:requirements -o b.pdf": DRAWS,
    "plot paper F11-2 -o c.png": DRAWS,
    "plot section -o d.dxf": {"cad"},
    "plot pocket -o e.dxf": {"cad"},
    "report -o f.html": {"report", "web"},
    "handbook -o g.html": {"report", "web"},
    "serve --no-browser": {"web"},
}
"""Command line → extras of which it needs one; None: it does without."""


def run(arguments):
    """Exit code of a command line, and what it says on standard error."""
    errors = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
        try:
            main(arguments)
        except SystemExit as end:
            return end.code, errors.getvalue().strip()


def fault(arguments, there):
    """What is wrong with how a command line ends."""
    code, said = run(arguments)
    missing = re.fullmatch(r"(error|ошибка): .*afmcalc\[\w+\].*", said.splitlines()[-1] if said else "")
    if (code == 0 and not missing) if there else (code == 2 and missing):
        return ""
    return f"{' '.join(arguments)}: exit {code}: {said[-300:]}"


if __name__ == "__main__":
    (extra,) = sys.argv[1:]
    os.chdir(tempfile.mkdtemp())
    faults = []
    for line, needed in ASKED.items():
        there = needed is None or extra in needed
        if line.startswith("serve") and there:
            continue  # it would not end
        for language in ("en", "ru"):
            faults += (
                [found]
                if (
                    found := fault([*line.split(), *(["--force"] if " -o " in line else []), "--lang", language], there)
                )
                else []
            )
    print(f"{extra or 'none'}: {len(ASKED)} command lines in two languages, {len(faults)} faults", *faults, sep="\n  ")
    sys.exit(bool(faults))
