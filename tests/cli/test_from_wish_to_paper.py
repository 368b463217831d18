"""A clutch of 350 N·m as a user makes it: requirements, choice, tolerances, check, report, paper."""

import re
import shutil

import pytest

from afmcalc.render.report.sheets import NAMES

WISHES = [
    "friction.min=", "friction.mean=", "friction.max=", "friction.material=moulded-dry", "wanted.nominal_torque=350 N*m",
    "wanted.accuracy_factor=1.3", "wanted.torque_max=", "limits.outer_diameter=220 mm", "limits.contact_force=15 kN",
    "search.mean_radius={start=0.06, stop=0.1, count=41}", "fixed.face_width=20 mm",
]  # fmt: skip
RISK = """
[tolerance.fields]
"friction" = { distribution = "triangular" }
"closing_spring.force" = { distribution = "normal", spread = "2 %" }
"""


PRINTED = pytest.mark.skipif(
    not any(map(shutil.which, NAMES)), reason="no headless browser on the path: nothing is printed"
)


# that a browser prints a page is asked of a small one in test_browser.py
@pytest.mark.every(2)
@pytest.mark.parametrize("paper", [[], pytest.param(["--pdf"], marks=PRINTED)], ids=["screen", "paper"])
def test_from_init_to_the_report(paper, undrawn, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert afmcalc("init", "wanted.toml", "--kind", "requirements").code == 0
    sets = [part for wish in WISHES for part in ("--set", wish)]
    front = afmcalc("design", "wanted.toml", *sets, "--json").json["result"]["front"]
    made = afmcalc("design", "wanted.toml", *sets, "--pick", 4, "-o", "clutch.toml", "--json")
    (chosen,) = made.json["result"]["picked"]
    assert made.json["result"]["front"] == front
    assert chosen["accuracy_factor"] <= 1.3 * (1 + 1e-9)
    assert chosen["nominal_torque"] == pytest.approx(350, rel=1e-3)

    text = (tmp_path / "clutch.toml").read_text(encoding="utf-8")
    judged = text.replace("[requirements]", '[requirements]\ntorque_max = "475 N*m"\nexceedance = 0.01')
    (tmp_path / "clutch.toml").write_text(judged + RISK, encoding="utf-8")
    check = afmcalc("check", "clutch.toml", "--strict", "--json")
    assert check.code == 0
    rows = {row["requirement"]: row for row in check.json["result"]["requirements"]}
    wanted = {"nominal_torque", "accuracy_factor", "torque_max"}
    assert set(rows) == {*wanted, "surface_pressure", "outer_diameter", "exceedance"}
    assert all(row["passed"] for row in rows.values())
    assert rows["outer_diameter"]["value"] <= 0.22 * (1 + 1e-9)
    assert rows["exceedance"]["value"] <= 0.01
    assert rows["accuracy_factor"]["value"] == chosen["accuracy_factor"]

    assert afmcalc("report", "clutch.toml", "-o", "report.html", "--author", "A. Designer", *paper).code == 0
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    words = re.sub(r"<[^>]*>", " ", page)
    for shown in ("A. Designer", "outer diameter of the friction faces", "probability that the torque exceeds"):
        assert shown in words
    if paper:
        assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")

    # one bound that this clutch does not hold fails the whole
    tighter = afmcalc("check", "clutch.toml", "--set", "requirements.outer_diameter=219 mm")
    assert tighter.code == 1
