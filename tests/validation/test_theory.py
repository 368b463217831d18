"""Theory, section 3: z 8, z_1 1, f 0.1…0.8 at gains 1.25, 2.5 and 5, published and by breakaway peaks."""

import pytest

from afmcalc.engines import build
from afmcalc.spec import make_spec


@pytest.mark.parametrize(("gain", "published", "peaks"), [(1.25, 1.875, 1.875), (2.5, 1.467, 2.75), (5.0, 1.241, 4.5)])
def test_published_and_peak_accuracy(gain, published, peaks):
    clutch = build(
        make_spec(
            {
                "variant": "differentiated",
                "friction": {"min": 0.1, "max": 0.8},
                "friction_group": {"pairs": 8, "mean_radius": 0.1},
                "closing_spring": {"force": 2000},
                "control_unit": {"gain": gain},
            }
        )
    )
    assert clutch.accuracy_factor == pytest.approx(published, abs=5e-4)
    assert clutch.accuracy_factor_peak == pytest.approx(peaks, abs=5e-4)
    # theory, section 3: z_1 f_max (1 + z_2 C f_min)/(z f_min)
    assert clutch.accuracy_factor_peak == pytest.approx(0.8 * (1 + 7 * gain * 0.1) / (8 * 0.1))
