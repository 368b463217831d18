"""Findings only, and the exit code they end in."""


def test_check_exit_codes(afmcalc):
    assert afmcalc("check").code == 0
    assert afmcalc("check", "--set", "C=2").code == 0
    strict = afmcalc("check", "--set", "C=2", "--strict", "--json")
    assert strict.code == 1
    assert strict.json["result"] == {"passed": False, "errors": 0, "warnings": 1, "notes": 4}
