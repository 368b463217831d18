"""Commands where one extra alone is installed, or none: each gives its result, or a sentence on what is missing.

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
    "plot pareto example:requirements -o b.pdf": {"pdf"}, "plot paper F11-2 -o c.png": {"pdf"},
    "layout example:envelope -o i.pdf": {"pdf"}, "layout example:envelope -o d.dxf": {"cad"}, "pocket -o e.dxf": {"cad"},
    "report -o f.html": DRAWS, "handbook -o g.html": DRAWS,
    "report -o h.pdf": {"pdf"}, "serve --no-browser": {"web"},
}  # fmt: skip
"""Command line → extras of which it needs one; None if it needs none."""


def fault(line, there, language):
    """Run a command line; return the fault in its exit code or message, empty if there is none."""
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
