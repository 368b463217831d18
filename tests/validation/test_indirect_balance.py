"""Indirect regulation as a balance of two bodies: pressure disc and thrust sleeve (S21, fig. 1; theory, section 5).

Forces on the sleeve along its axis: spring 13 (F_п1 − c_1 x) and the balls (T tan α/r) push it off the stop, spring 11
(F_п2 + c_2 x) holds it there, the stop 10 pushes it with S, the key resists with 2 T f_1/d whichever way it slides. The
disc is pressed by spring 13 and, the stop being part of it, by S. So S ≥ 0, x ≥ 0, S x = 0. Off the stop the sleeve
slides to the next place where nothing pushes it on; with pockets whose wall steepens along the travel (section 12) the
push is a parabola over the travel, and there may be none.
"""

from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import FRICTION, indirect_specs

from afmcalc.engines import build
from afmcalc.spec import make_spec
from afmcalc.spec.edit import with_key

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
        self.slope = (unit.gain_slope or 0.0) / spec.friction_group.mean_radius / spec.closing_spring.stiffness
        self.key = 2 * unit.key_friction / unit.hub_diameter
        self.friction_set = own.mean if spec.adjustment.method == "mean-friction" else own.min
        nominal = self.lever * self.friction_set * self.spring
        self.control = self.spring + nominal * self.balls - nominal * self.key

    def push(self, friction, way):
        """What pushes the sleeve off its stop, the key's friction fully one way: over the slackening c_1 x."""
        # N + T tan α/r ± 2 T f_1/d − F_п2 − c_2 x with N = F_п1 − c_1 x
        lever, pressed = self.lever * friction, np.polynomial.Polynomial([self.spring, -1])
        steeper = np.polynomial.Polynomial([1 + lever * (self.balls + way * self.key), lever * self.slope])
        return pressed * steeper - np.polynomial.Polynomial([self.control, self.ratio])

    def places(self, friction, way):
        """Slackenings at which nothing pushes, in ascending order; no clutch so near a jump that rounding decides."""
        push = self.push(friction, way).trim()
        constant, linear, *square = push.coef
        disc = linear**2 - 4 * constant * square[0] if square else linear**2
        assume(abs(disc) > 1e-5 * (linear**2 + self.spring**2 * (square[0] if square else 0) ** 2))
        return sorted(root.real for root in push.roots() if abs(root.imag) == 0 and root.real > 0)

    def at_stop(self, friction, way):
        normal = self.control / (1 + self.lever * friction * (self.balls + way * self.key))
        return State(normal, self.lever * friction * normal, 0.0, normal - self.spring)

    def off_stop(self, friction, slack):
        normal = self.spring - slack
        return State(normal, self.lever * friction * normal, slack, 0.0)

    def rising(self, friction):
        """At rest until the balls overcome spring 11; then the next place where nothing pushes."""
        seated = self.at_stop(friction, OFF)
        if seated.stop >= -1e-13 * self.control:
            return seated
        return self.off_stop(friction, self.places(friction, OFF)[0])

    def releases(self, state):
        """Friction down to which the key can hold a sleeve: there it and the balls just bear what spring 11 has over."""
        over = self.control + self.ratio * state.slack - state.normal
        return over / (self.lever * state.normal * (self.balls + self.slope * state.slack + self.key))

    def returning(self, state, friction):
        """The state after friction has fallen a little to ``friction``: locked by the key while that can hold the sleeve.

        At the stop too: it is stiff, not rigid, so that to be relieved or loaded the sleeve must slide against the key.
        """
        if friction >= self.releases(state) * (1 - 1e-12):
            return state._replace(torque=self.lever * friction * state.normal)
        back = [slack for slack in self.places(friction, BACK) if slack <= state.slack]
        # the place it slides back to is the next below, if what pushed it back ends there
        if back and self.push(friction, BACK).deriv()(back[-1]) < 0:
            return self.off_stop(friction, back[-1])
        return self.at_stop(friction, BACK)


@st.composite
def frictions(draw, spec):
    """Below, at and above the setting."""
    setting = Sleeve(spec).friction_set
    return draw(st.one_of(FRICTION, st.just(setting), st.floats(0.99 * setting, 1.01 * setting)))


def close(value, scale=0.0):
    return pytest.approx(value, rel=1e-9, abs=1e-9 * scale)


CLUTCHES = st.one_of(indirect_specs(), indirect_specs(curved=True))


@given(st.data(), CLUTCHES)
def test_rising(data, spec):
    friction = data.draw(frictions(spec))
    clutch, sleeve = build(spec), Sleeve(spec)
    if friction == pytest.approx(sleeve.friction_set, rel=1e-9):
        assume(sleeve.push(friction, OFF).deriv()(0.0) < 0)  # else it is about to jump
    found = sleeve.rising(friction)
    assert clutch.torque(friction) == close(found.torque)
    assert clutch.normal_force(friction) == close(found.normal)
    travel = clutch.travel(friction) * spec.closing_spring.stiffness
    assert travel == close(found.slack, sleeve.spring)
    # the stop's reaction is what the pack bears beyond spring 13
    assert clutch.normal_force(friction) - (sleeve.spring - travel) == close(found.stop, sleeve.control)
    assert (friction > sleeve.friction_set * (1 + 1e-9)) <= (found.stop <= 0)
    assert (friction < sleeve.friction_set * (1 - 1e-9)) <= (found.slack == 0)
    # the balls push the sleeve with what the springs and the key leave
    key = found.torque * sleeve.key
    balls = sleeve.control + sleeve.ratio * found.slack + found.stop - (sleeve.spring - found.slack) + key
    assert found.slack == 0 or clutch.release_force(friction) == close(balls, sleeve.spring)


@given(CLUTCHES)
def test_at_rest_and_over_the_range(spec):
    clutch, sleeve, own = build(spec), Sleeve(spec), spec.friction.range
    assume(not 0 < own.max / sleeve.friction_set - 1 < 1e-9)  # rounding decides whether it leaves its stop
    assert clutch.control_force == close(sleeve.control)
    assert clutch.pack_force_at_rest == close(sleeve.rising(0.0).normal)
    ends = [sleeve.rising(friction).torque for friction in (own.min, own.max)]
    most = max(
        *ends, clutch.nominal_torque * (spec.adjustment.margin if spec.adjustment.method != "min-friction" else 1)
    )
    assert clutch.torque_max == close(most)
    assert clutch.accuracy_factor == close(most / min(ends))
    state, least = sleeve.rising(own.max), ends[1]
    releases = max(min(sleeve.releases(state), own.max), own.min)
    for friction in sorted({releases, *np.linspace(own.min, own.max, 7)}, reverse=True):
        state = sleeve.returning(state, friction)
        least = min(least, state.torque)
    assert clutch.accuracy_factor_hysteresis == close(most / least)


@given(CLUTCHES, st.lists(st.floats(0.01, 1), min_size=1, max_size=8))
def test_returning_from_the_largest_friction(spec, shares):
    """Friction falls in steps; where it has fallen to, not how, decides."""
    clutch, sleeve, top = build(spec), Sleeve(spec), spec.friction.range.max
    state = sleeve.rising(top)
    assert clutch.torque_returning(top) == close(state.torque)
    for share in sorted(shares, reverse=True):
        state = sleeve.returning(state, share * top)
        assert clutch.torque_returning(share * top) == close(state.torque)
        assert state.torque <= sleeve.rising(share * top).torque * (1 + 1e-12)


@given(indirect_specs(), st.floats(1, 8))
def test_the_slope_that_holds_the_torque(spec, reach):
    """T = T_н for every friction from the setting on; x = (F_п1/c_1)(1 − f_set/f) whatever the gain."""
    held = build(with_key(spec, "control_unit.pocket", "constant-torque"))
    springs, at_set = spec.closing_spring, held.friction_set
    friction = at_set * np.linspace(1, reach, 50)
    assert held.torque(friction) == pytest.approx(springs.force * held.torque_per_force(), rel=1e-12)
    assert held.travel(friction) == pytest.approx(
        springs.force / springs.stiffness * (1 - at_set / friction),
        rel=1e-9,
        abs=1e-12 * springs.force / springs.stiffness,
    )


@given(indirect_specs())
def test_locked_then_moving_then_seated(spec):
    """The key lets go at f_max κ/κ₊, the sleeve is back at f_set κ/κ₊ (theory, section 5)."""
    sleeve, top = Sleeve(spec), spec.friction.range.max
    assume(top > sleeve.friction_set * 1.001)
    start = sleeve.rising(top)
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
