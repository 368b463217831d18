"""Standard balls: the list that ships against the sizes of ISO 3290-1, and lists of the user's own."""

import pytest

from afmcalc.errors import AfmcalcError
from afmcalc.messages import language, speaking, translate
from afmcalc.spec.lists import ball_designation, diameters

INCH = 25.4
PRINTED = 5e-6
"""Half a unit of the fifth decimal, in mm: the sizes are printed to five."""
MAKERS_LIST = (
    1.5, 1.5875, 2, 2.3812, 2.5, 2.7781, 3, 3.175, 3.5, 3.9688, 4, 4.5, 4.7625, 5, 5.5562, 6, 6.35, 7.1438, 7.9375,
    8.7312, 9.525, 10, 10.3188, 11.1125, 11.9062, 12, 12.7, 13.4937, 14.2875, 15, 15.0812, 15.875, 16, 16.6687,
    17.4625, 19.05, 19.8438, 20, 20.6375, 23.8125, 25, 25.4,
)  # fmt: skip
"""A maker's balls to ISO 3290 grades, printed to four decimals."""


def in_mm(source=None):
    return [1000 * size for size in diameters(source)]


def test_every_size_is_metric_or_a_sixty_fourth_of_an_inch():
    for size in in_mm():
        sixty_fourths = round(64 * size / INCH)
        is_inch = abs(size - sixty_fourths * INCH / 64) <= PRINTED * (1 + 1e-6)
        is_metric = abs(size - round(size, 1)) < 1e-12
        assert is_inch or is_metric, size


def test_the_list_ascends_to_its_ends():
    sizes = in_mm()
    assert sizes == sorted(set(sizes))
    assert (len(sizes), sizes[0], sizes[-1]) == (148, pytest.approx(0.3), pytest.approx(4.125 * INCH))


def test_a_makers_list_is_contained():
    sizes = in_mm()
    for size in MAKERS_LIST:
        assert min(abs(size - other) for other in sizes) <= 1e-4 / 2 + PRINTED, size


LISTS = {
    "own.toml": 'diameters = [8, "5 mm", 6.35]', "own.csv": "# mine\ndiameter_mm\n8\n5\n6.35\n",
    "OWN.CSV": "\ufeffdiameter_mm\r\n6.35\r\n5\r\n8\r\n", "bom.toml": "\ufeffdiameters = [6.35, 5, 8]",
}  # fmt: skip


@pytest.mark.parametrize("name", LISTS)
def test_a_list_of_the_users_own(tmp_path, name):
    (tmp_path / name).write_bytes(LISTS[name].encode())
    assert in_mm(tmp_path / name) == pytest.approx([5, 6.35, 8])


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("a.csv", "5\n6\n", "must begin with the heading diameter_mm"), ("a.csv", "diameter_mm\n", "then one ball diameter"),
        ("a.csv", "diameter_mm\n5\n6,35\n", "line 3: '6,35' is no diameter"), ("a.csv", "diameter_mm\nnan\n", "line 2: 'nan' is no diameter"),
        ("a.csv", "diameter_mm\n0\n", "greater than 0"), ("a.toml", "diameter_mm\n5\n", "is not valid TOML"),
        ("a.toml", "diameters = [1" + 400 * "0" + "]", "beyond the range of numbers"),
        ("a.toml", "diameters = [1" + 5000 * "0" + "]", "is not valid TOML"), ("a.toml", "diameters = [true]", "no diameter"),
    ],
)  # fmt: skip
def test_what_is_no_list(tmp_path, name, text, says):
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(AfmcalcError, match=says) as raised:
        diameters(tmp_path / name)
    assert name in str(raised.value)


def test_a_standard_ball_is_named_as_it_is_ordered():
    for size, name in ((25, "25"), (20.6375, "20.638"), (20.638, "20.638"), (5.55625, "5.556")):
        named = ball_designation(size / 1000)
        assert named == f"ball {name} mm, ISO 3290-1"
        with speaking(language("ru")):
            assert translate(named) == f"Шарик {name.replace('.', ',')} ГОСТ 3722-2014"


def test_only_a_standard_ball_has_a_designation(afmcalc):
    assert ball_designation(0.0251) is None
    for sizes, shown in (("25", True), ("25.1", False)):
        told = afmcalc("--lang", "ru", "synthesize", "--set", f"control_unit.ball_diameter={sizes} mm").out
        assert ("Шарик 25 ГОСТ 3722-2014" in told) is shown
        assert ("без степени точности" in told) is shown
