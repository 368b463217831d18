"""F11's ratios n, p and m of unlike materials, held against (17) written out here."""

import pytest

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.solve.solve import NotAttainableError, solve
from afmcalc.analysis.sweep.axes import parse_axis
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

UNLIKE = "example:unlike-materials"
F_1MIN, N, P, M = 0.1, 1.0, 1.2, 6.0
"""Of the example; z_1 1, z_2 6, C 1.25."""


def factor(n=N, p=P, m=M, z1=1, z2=6, gain=1.25):
    """F11 (17) as printed."""
    return m * (z1 + z2 * n) * (1 + z2 * gain * p * F_1MIN) / ((z1 + z2 * p) * (1 + z2 * gain * n * m * F_1MIN))


@pytest.fixture(scope="module")
def clutch():
    return build(read_spec(UNLIKE))


def swept(clutch, *texts):
    return accuracy(clutch, [parse_axis(text, clutch.spec) for text in texts])[0].sweep


@pytest.mark.parametrize(
    ("name", "values"), [("n", (0.5, 0.8, 1.5, 3)), ("p", (0.3, 1, 1.7)), ("m", (1.3, 3, 6, 7.5, 12))]
)
def test_one_ratio_moves_and_the_others_stay(clutch, name, values):
    (series,) = swept(clutch, f"{name}={','.join(map(str, values))}")
    assert series.values == list(values)
    assert series.accuracy_factor == pytest.approx([factor(**{name: value}) for value in values], rel=1e-12)


def test_which_friction_moves(clutch):
    """T_min = F R (z_1 f_1min + z_2 f_2min)/(1 + z_2 C f_2min) does not follow n and m, T_max does not follow p."""

    def torque(f1, f2):
        return 2000 * 0.1 * (f1 + 6 * f2) / (1 + 7.5 * f2)

    (n,), (p,), (m,) = (swept(clutch, text) for text in ("n=0.5,1.5", "p=0.5,1.5", "m=3,6"))
    assert n.nominal_torque == m.nominal_torque == pytest.approx([torque(0.1, 0.12)] * 2)
    assert p.nominal_torque == pytest.approx([torque(0.1, 0.05), torque(0.1, 0.15)])
    assert n.torque_max == pytest.approx([torque(0.6, 0.3), torque(0.6, 0.9)])
    assert p.torque_max == pytest.approx([torque(0.6, 0.6)] * 2)
    assert m.torque_max == pytest.approx([torque(0.3, 0.3), torque(0.6, 0.6)])


def test_materials_of_the_catalogue_give_way(clutch):
    gone = {"friction.driven.min": None, "friction.driven.max": None, "friction.driven.material": "moulded-dry"}
    of_catalogue = build(respecified(clutch.spec, gone))
    low, high = of_catalogue.friction[1].min, of_catalogue.friction[1].max
    result, findings = accuracy(of_catalogue, [parse_axis("n=1", of_catalogue.spec)])
    assert result.sweep[0].accuracy_factor == pytest.approx([factor(1, low / 0.1)])
    assert high != 0.6
    assert [one.path for one in findings if one.code == "sweep-replaces"] == ["friction.driven.material"]


@pytest.mark.parametrize(("name", "wanted", "least"), [("n", 1.75, 0.2), ("p", 1.6, 0), ("m", 1.5, 1.2)])
def test_solved_for(clutch, name, wanted, least):
    result, solved, _ = solve(clutch, name, "accuracy_factor", wanted)
    assert result.value > least
    assert factor(**{name: result.value}) == pytest.approx(wanted, rel=1e-9)
    assert solved.accuracy_factor == pytest.approx(wanted, rel=1e-9)
    assert result.unit == "1"


def test_the_ends_of_a_ratio(clutch):
    """m ends at the gain limit, f_1max = 1/(z_1 C) = 0.8; p where f_2min is f_2max, 0.6."""
    for name, wanted, end in (("m", 5, 8), ("p", 1.01, 6), ("n", 1.5, 0.2)):
        with pytest.raises(NotAttainableError) as refused:
            solve(clutch, name, "accuracy_factor", wanted)
        assert refused.value.at == pytest.approx(end)
        assert refused.value.best == pytest.approx(factor(**{name: end}))
    assert solve(clutch, "m", "accuracy_factor", 1.9, beyond_limit=True)[0].value > 8


def test_slopes(clutch):
    """F11 (18), (22) as mended, at z_2 C f_1max = 4.5, and by differences of (17)."""
    result, _ = accuracy(clutch)
    assert result.slope_in_ratio_max == pytest.approx(6 * 6 * 1.9 * 0.25 / (8.2 * 5.5**2), rel=1e-12)
    assert result.slope_in_ratio_min == pytest.approx(6 * 6 * 7 * (0.125 - 1) / (8.2**2 * 5.5), rel=1e-12)
    step = 1e-6
    assert result.slope_in_ratio_max == pytest.approx((factor(n=1 + step) - factor(n=1 - step)) / (2 * step), rel=1e-6)
    assert result.slope_in_ratio_min == pytest.approx(
        (factor(p=1.2 + step) - factor(p=1.2 - step)) / (2 * step), rel=1e-6
    )


@pytest.mark.parametrize("name", ["n", "p", "m"])
def test_only_unlike_materials_have_ratios(name):
    default = build(read_spec("example:default"))
    with pytest.raises(AfmcalcError, match="is no key or symbol; . is a ratio of unlike materials") as swept_for:
        parse_axis(name, default.spec)
    with pytest.raises(AfmcalcError, match="cannot be solved for; . is a ratio of unlike materials"):
        solve(default, name, "accuracy_factor", 1.5)
    assert ("control_unit.balls?" in str(swept_for.value)) == (name == "n")
    result, _ = accuracy(default)
    assert result.slope_in_ratio_max is None


@pytest.mark.parametrize("other", ["friction.driving.min", "friction.driven.max", "friction.driven.mean"])
def test_a_ratio_beside_a_coefficient_is_refused(clutch, other):
    with pytest.raises(AfmcalcError, match="cannot be swept together"):
        swept(clutch, "m=4,5", f"{other}=0.11,0.3")
