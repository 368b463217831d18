"""Sweeps: each point is a single calculation; ranges without being given; F11's ratios n, p and m of unlike materials."""

import numpy as np
import pytest

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.solve.solve import NotAttainableError, solve
from afmcalc.analysis.sweep.axes import parse_axis
from afmcalc.analysis.sweep.grid import evaluate
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.spec import read_spec


def test_sweep_is_the_single_calculations(afmcalc):
    sweep = afmcalc("accuracy", "--sweep", "z=4,8,16", "--sweep", "C=0.2:1:3", "--json").json["result"]["sweep"]
    assert [entry["parameter"] for entry in sweep] == ["z", "C"]
    assert [entry["path"] for entry in sweep] == ["friction_group.pairs", "control_unit.gain"]
    assert len(sweep[0]["values"]) == 9
    for index, (z, c) in enumerate(zip(sweep[0]["values"], sweep[1]["values"], strict=True)):
        single = ["--set", f"z={z:g}", "--set", f"C={c!r}", "--json"]
        torque, accuracy = (afmcalc(command, *single).json["result"] for command in ("torque", "accuracy"))
        assert sweep[0]["accuracy_factor"][index] == accuracy["accuracy_factor"]
        assert sweep[1]["nominal_torque"][index] == torque["nominal_torque"]
        assert sweep[1]["torque_max"][index] == torque["torque"]["max"]


@pytest.mark.parametrize(
    "name",
    ["C", "z", "z1", "R", "F", "f_min", "f_max", "beta", "friction.mean", "drive.dynamic_factor", "alpha=0:0.5:5"],
)
def test_every_sweep_has_a_sensible_range(name, afmcalc):
    run = afmcalc("accuracy", "--sweep", name, "--json")
    assert run.code == 0, run.err
    (entry,) = run.json["result"]["sweep"]
    assert len(entry["values"]) == len(entry["accuracy_factor"]) >= 3
    assert min(entry["accuracy_factor"]) >= 1


@pytest.mark.parametrize(
    "sweep",
    ["", "x", "variant", "C=", "C=1:2", "C=1:2:1", "C=1:2:x", "C=a,b", "C=-1:1:5", "z=1.5,2", "f_min=0.5:0.9:5", "F=1 J,2 J",
     "C=nan", "z=1,0", "z1=1:9:9", "C=0:1:99999999999", "friction.driving.min"],
)  # fmt: skip
def test_bad_sweeps(sweep, afmcalc, tmp_path):
    run = afmcalc("accuracy", "--sweep", sweep, "-o", tmp_path / "x")
    assert run.code == 2, run.out
    assert run.err.strip().splitlines()[-1].startswith("error: ")
    assert not (tmp_path / "x").exists()


def test_a_long_sweep_is_calculated_in_stretches_that_join():
    """More points than one stretch takes, against the formula F11 (14) over all of them."""
    gain = np.linspace(0, 1.25, 96_001)
    found = evaluate(read_spec(), {"control_unit.gain": gain}, {"factor": lambda clutch: clutch.accuracy_factor})
    np.testing.assert_allclose(found["factor"], 8 * (1 + 0.7 * gain) / (1 + 5.6 * gain), rtol=1e-14)


def test_arrays_of_several_shapes_broadcast():
    gain, pairs = np.linspace(0, 1, 5), np.array([[4.0], [8.0], [16.0]])
    outputs = {"factor": lambda clutch: clutch.accuracy_factor, "radius": lambda clutch: clutch.mean_radius}
    found = evaluate(read_spec(), {"control_unit.gain": gain, "friction_group.pairs": pairs}, outputs)
    controlled = pairs - 1
    np.testing.assert_allclose(found["factor"], 8 * (1 + 0.1 * controlled * gain) / (1 + 0.8 * controlled * gain))
    assert found["radius"].shape == (3, 5)
    assert (found["radius"] == 0.1).all()


def test_what_is_swept_heads_its_column(afmcalc):
    """The reduced gain is no key of the spec: its values are not told as gains."""
    run = afmcalc("accuracy", "example:all-driving", "--sweep", "zC=1:2:2", "--format", "csv")
    head, first, _ = run.out.splitlines()
    assert head.startswith("reduced_gain [1],accuracy_factor [1]")
    low, high = (getattr(build(read_spec("example:all-driving")).friction[0], end) for end in ("min", "max"))
    told = [float(each) for each in first.split(",")[:2]]
    assert told == pytest.approx([1.0, high * (1 + low) / (low * (1 + high))])


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
