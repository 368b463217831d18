"""Code as a user writes it: mypy, which checks this file with the package, knows every type; a test runs it too."""

from contextlib import suppress
from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import afmcalc

clutch = afmcalc.load(set={"control_unit.gain": 1.2, "F": "3 kN"})
assert_type(clutch, afmcalc.Clutch)
assert_type(clutch.with_(gain=0.3, nominal_torque="200 N*m"), afmcalc.Clutch)
assert_type(clutch.torque().nominal_torque, float)
assert_type(clutch.torque(0.3), float)
assert_type(clutch.torque(np.linspace(0.1, 0.8, 3)), NDArray[np.float64])
assert_type(clutch.accuracy(sweep="C=0,1").accuracy_factor, float)
assert_type(clutch.adjust().scatter_ratio, float | None)
assert_type(clutch.overload().optimal_reduced_gain, float)
assert_type(clutch.pocket().ball_diameter_standard, float | None)
assert_type(clutch.life(sweep="dT=500,900").protected.as_set, float | None)
assert_type(clutch.springs(kind="coil", top=1).utilisation, float | None)
assert_type(clutch.solve("accuracy_factor", 2, for_="C").value, float)
assert_type(clutch.check().passed, bool)
assert_type(clutch.explain("torque").steps[0].value, float)
assert_type(afmcalc.compare(clutch, variants=True).clutches[0].accuracy_factor, float)
assert_type([finding.code for finding in clutch.check().findings], list[str])

at_most = clutch.at("f_max", gain=0.7)
assert_type(at_most.torque, float | NDArray[np.float64])
assert_type(clutch.names(), list[str])

drive = afmcalc.load("example:drive")
assert_type(drive.heat().energy.max, float | None)
assert_type(drive.effects().accuracy_factor, float)

# type checkers also refuse names that do not exist
with suppress(AttributeError):
    clutch.acuracy()  # type: ignore[attr-defined]
with suppress(AttributeError):
    at_most.torqe  # type: ignore[attr-defined]  # noqa: B018
with suppress(AttributeError):
    clutch.check().pased  # type: ignore[attr-defined]  # noqa: B018
with suppress(AttributeError):
    afmcalc.lode()  # type: ignore[attr-defined]
