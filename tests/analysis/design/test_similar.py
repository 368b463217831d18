"""Requirements made of a clutch: they are valid, and a search among them finds clutches that hold them."""

import tomllib

import pytest
import tomli_w

from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.similar import requirements_like
from afmcalc.engines import build
from afmcalc.spec import read_spec
from afmcalc.spec.requirements import make_requirements

CLUTCHES = ["default", "conventional", "indirect", "constant-torque", "unlike-materials", "envelope", "machine-clutch"]


@pytest.mark.parametrize("name", CLUTCHES)
def test_a_clutch_is_found_by_what_it_answers(name):
    clutch = build(read_spec(f"example:{name}"))
    need = make_requirements(tomllib.loads(tomli_w.dumps(requirements_like(clutch))))
    assert need.variants == (clutch.spec.variant,)
    if clutch.spec.machine is None:
        asked = clutch.spec.requirements
        wanted = asked.nominal_torque or asked.machine_torque if asked else None
        assert need.clutch_torque == pytest.approx(wanted or clutch.nominal_torque, rel=5e-4)
    result, _ = design(need, simulate=False)
    assert result.front
