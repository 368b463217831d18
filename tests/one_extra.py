"""The answer of a command where one extra alone is installed, or none: its result, or a sentence that names what is missing.

``python tests/one_extra.py NAME`` (or ``''``) with the Python of an environment that has only it.
"""

import contextlib
import io
import os
import re
import sys
import tempfile

from afmcalc.cli.main import main

DRAWS = {"plot", "report", "pdf", "web"}
ASKED = {
    "torque": None, "plot torque -o a.svg": DRAWS,
    "plot pareto example:requirements -o b.pdf": DRAWS, "plot paper F11-2 -o c.png": DRAWS,
    "layout example:envelope -o i.pdf": {"pdf"}, "layout example:envelope -o d.dxf": {"cad"}, "pocket -o e.dxf": {"cad"},
    "report -o f.html": DRAWS, "handbook -o g.html": DRAWS,
    "report -o h.pdf": {"pdf"}, "serve --no-browser": {"web"},
}  # fmt: skip
"""Command line → extras of which it needs one; None: it does without."""


def fault(line, there, language):
    """Faults in how a command line ends."""
    errors, arguments = io.StringIO(), [*line.split(), *(["--force"] if " -o " in line else []), "--lang", language]
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
        try:
            main(arguments)
        except SystemExit as end:
            code, said = end.code, errors.getvalue().strip()
    missing = re.search(r"^(error|ошибка): .*afmcalc\[\w+\]", said, re.MULTILINE)
    right = code == 0 and not missing if there else code == 2 and missing
    return "" if right else f"{' '.join(arguments)}: exit {code}: {said[-300:]}"


if __name__ == "__main__":
    (extra,) = sys.argv[1:]
    os.chdir(tempfile.mkdtemp())
    given = {line: needed is None or extra in needed for line, needed in ASKED.items()}
    given.pop("serve --no-browser" if extra == "web" else "", None)  # it would not end
    faults = [fault(line, there, language) for line, there in given.items() for language in ("en", "ru")]
    print(f"{extra or 'none'}: {len(faults)} command lines", *filter(None, faults), sep="\n  ")
    sys.exit(any(faults))
