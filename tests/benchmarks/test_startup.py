"""Start-up of the whole process against importing the program's own four libraries and doing nothing.

Run with ``pytest tests/benchmarks``; the bytecode of both is compiled before they are timed, as pip does it.
"""

import shutil
import sysconfig

import pytest
from ratios import BASELINE, median_ratio, process

PROGRAM = shutil.which("afmcalc", path=sysconfig.get_path("scripts")) or "afmcalc"

SI = """
variant = "differentiated"
friction = { min = 0.1, mean = 0.3, max = 0.8 }
friction_group = { pairs = 8, mean_radius = 0.1 }
closing_spring = { force = 2000 }
control_unit = { gain = 0.5 }
"""
UNITS = SI.replace("mean_radius = 0.1", 'mean_radius = "100 mm"').replace("force = 2000", 'force = "2 kN"')


@pytest.mark.parametrize(
    ("name", "text", "arguments", "limit"),
    [
        ("torque --json, SI numbers", SI, ["torque", "SPEC", "--json"], 1.1),
        ("torque as a table, SI numbers", SI, ["torque", "SPEC"], 1.2),
        ("torque --json, unit strings", UNITS, ["torque", "SPEC", "--json"], 1.15),
        ("torque as a table, unit strings", UNITS, ["torque", "SPEC"], 1.2),
        ("--help", SI, ["--help"], 1.0),
    ],
)
def test_startup(name, text, arguments, limit, tmp_path, report):
    spec = tmp_path / "spec.toml"
    spec.write_text(text)
    command = [PROGRAM, *(str(spec) if part == "SPEC" else part for part in arguments)]
    report(name, median_ratio(process(command), process(BASELINE), pairs=21), limit)
