"""Indirect regulation as a balance of two bodies: pressure disc and thrust sleeve (S21, fig. 1; theory, section 5).

Forces on the sleeve along its axis: spring 13 (F_п1 − c_1 x) and the balls (T tan α/r) push it off the stop, spring 11
(F_п2 + c_2 x) holds it there, the stop 10 pushes it with S, the key resists with 2 T f_1/d whichever way it slides. The
disc is pressed by spring 13 and, the stop being part of it, by S. So S ≥ 0, x ≥ 0, S x = 0: one of two linear systems.
"""

from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import FRICTION, indirect_specs

from afmcalc.engines import build
from afmcalc.spec import make_spec

OFF, BACK = -1.0, 1.0
"""Which way the key's friction acts on a sleeve that slides off the stop, or back to it."""


class State(NamedTuple):
    """Normal force and torque, slackening c_1 x of spring 13, reaction S of the stop."""

    normal: float
    torque: float
    slack: float
    stop: float


class Sleeve:
    """The forces of S21 (1)–(4), (6)–(9); F_п2 is what leaves the stop without load at the setting."""

    def __init__(self, spec):
        unit, own = spec.control_unit, spec.friction.range
        self.spring = spec.closing_spring.force
        self.ratio = spec.control_spring.stiffness / spec.closing_spring.stiffness
        self.lever = spec.friction_group.pairs * spec.friction_group.mean_radius
        self.balls = unit.gain / spec.friction_group.mean_radius
        self.key = 2 * unit.key_friction / unit.hub_diameter
        self.friction_set = own.mean if spec.adjustment.method == "mean-friction" else own.min
        nominal = self.lever * self.friction_set * self.spring
        self.control = self.spring + nominal * self.balls - nominal * self.key

    def sliding(self, friction, way):
        """The sleeve in balance with the key's friction fully against its motion."""
        # N = F_п1 − c_1 x + S;  N + T tan α/r ± 2 T f_1/d = F_п2 + c_2 x
        axial = 1 + self.lever * friction * (self.balls + way * self.key)
        seated = self.control / axial
        stop = seated - self.spring
        moved, slack = np.linalg.solve([[1, 1], [axial, -self.ratio]], [self.spring, self.control])
        assert (stop > 0) != (slack > 0) or max(abs(stop), abs(slack)) < 1e-9 * self.control, "one state is possible"
        normal = seated if stop >= 0 else moved
        return State(normal, self.lever * friction * normal, 0.0 if stop >= 0 else slack, max(stop, 0.0))

    def returning(self, state, friction):
        """The state after friction has fallen to ``friction``: locked by the key while that can hold the sleeve.

        At the stop too: it is stiff, not rigid, so that to be relieved or loaded the sleeve must slide against the key.
        """
        torque = self.lever * friction * state.normal
        pushed_back = self.control + self.ratio * state.slack - state.normal - torque * self.balls
        if pushed_back <= torque * self.key:
            return state._replace(torque=torque)
        return self.sliding(friction, BACK)


@st.composite
def frictions(draw, spec):
    """Below, at and above the setting."""
    setting = Sleeve(spec).friction_set
    return draw(st.one_of(FRICTION, st.just(setting), st.floats(0.99 * setting, 1.01 * setting)))


def close(value, scale=0.0):
    return pytest.approx(value, rel=1e-9, abs=1e-9 * scale)


@given(st.data(), indirect_specs())
def test_rising(data, spec):
    friction = data.draw(frictions(spec))
    clutch, sleeve = build(spec), Sleeve(spec)
    found = sleeve.sliding(friction, OFF)
    assert clutch.torque(friction) == close(found.torque)
    assert clutch.normal_force(friction) == close(found.normal)
    travel = clutch.travel(friction) * spec.closing_spring.stiffness
    assert travel == close(found.slack, sleeve.spring)
    # the stop's reaction is what the pack bears beyond spring 13
    assert clutch.normal_force(friction) - (sleeve.spring - travel) == close(found.stop, sleeve.control)
    assert (friction > sleeve.friction_set * (1 + 1e-9)) <= (found.stop == 0)
    assert (friction < sleeve.friction_set * (1 - 1e-9)) <= (found.slack == 0)


@given(indirect_specs())
def test_at_rest_and_over_the_range(spec):
    clutch, sleeve, own = build(spec), Sleeve(spec), spec.friction.range
    assert clutch.control_force == close(sleeve.control)
    assert clutch.pack_force_at_rest == close(sleeve.sliding(0.0, OFF).normal)
    ends = [sleeve.sliding(friction, OFF).torque for friction in (own.min, own.max)]
    assert clutch.accuracy_factor == close(ends[1] / ends[0])
    last = sleeve.returning(sleeve.sliding(own.max, OFF), own.min)
    assert clutch.accuracy_factor_hysteresis == close(ends[1] / last.torque)


@given(indirect_specs(), st.lists(st.floats(0.01, 1), min_size=1, max_size=8))
def test_returning_from_the_largest_friction(spec, shares):
    """Friction falls in steps; where it has fallen to, not how, decides."""
    clutch, sleeve, top = build(spec), Sleeve(spec), spec.friction.range.max
    state = sleeve.sliding(top, OFF)
    assert clutch.torque_returning(top) == close(state.torque)
    for share in sorted(shares, reverse=True):
        state = sleeve.returning(state, share * top)
        assert clutch.torque_returning(share * top) == close(state.torque)
        assert state.torque <= sleeve.sliding(share * top, OFF).torque * (1 + 1e-12)


@given(indirect_specs())
def test_locked_then_moving_then_seated(spec):
    """The key lets go at f_max κ/κ₊, the sleeve is back at f_set κ/κ₊ (theory, section 5)."""
    sleeve, top = Sleeve(spec), spec.friction.range.max
    assume(top > sleeve.friction_set * 1.001)
    start = sleeve.sliding(top, OFF)
    fall = (sleeve.balls - sleeve.key) / (sleeve.balls + sleeve.key)
    assume(fall > 1e-6)

    def after(friction):
        return sleeve.returning(start, friction * fall)

    assert after(top * (1 + 1e-6)).slack == start.slack
    moving = after((top + sleeve.friction_set) / 2)
    assert 0 < moving.slack < start.slack
    assert moving.stop == 0
    assert after(sleeve.friction_set * (1 + 1e-4)).slack > 0
    seated = after(sleeve.friction_set * (1 - 1e-4))
    assert (seated.slack, seated.stop > 0) == (0, True)
    assert build(spec).torque_returning(sleeve.friction_set * fall) == close(
        sleeve.lever * sleeve.friction_set * fall * sleeve.spring
    )


def p5(**adjustment):
    """The clutch of P5, C = 1, F_п1 = 2 kN."""
    return make_spec(
        {
            "variant": "indirect",
            "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
            "friction_group": {"pairs": 8, "mean_radius": 0.1},
            "closing_spring": {"force": 2000.0, "stiffness": 20e3},
            "control_spring": {"stiffness": 10e3},
            "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
            "adjustment": adjustment,
        }
    )


def test_the_figures_of_the_theory():
    """Set at 0.3: T(0.1) = 237.6, K_т = 3.265. Set at 0.1: K_т = 3.586, 5.48 when friction falls, T_ret = 105 < 160."""
    for clutch, torque, factor in ((build(p5(method="mean-friction")), 237.6, 3.265), (build(p5()), 160.0, 3.586)):
        assert clutch.torque(0.1) == pytest.approx(torque, abs=0.05)
        assert clutch.accuracy_factor == pytest.approx(factor, abs=5e-4)
    assert clutch.accuracy_factor_hysteresis == pytest.approx(5.48, abs=5e-3)
    assert clutch.torque_returning(0.1) == pytest.approx(105, abs=0.5)
    assert clutch.nominal_torque == pytest.approx(160)
