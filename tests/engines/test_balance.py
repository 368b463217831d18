"""A sleeve between straight or disc springs, behind straight or curved walls, against a march over its travel.

Spring 13 presses pack and sleeve with N(x), spring 11 pushes it back with Q(x), the balls lift it with T tan α/r, the key
resists with 2 T f_1/d whichever way it slides, T = z R f N (S21, fig. 1). Off its stop nothing pushes it on where
f = (Q/N − 1)/(z κ(x)), κ(x) = C + C_1 x ∓ 2 R f_1/d. Friction that rises takes it to the first such place, friction
that falls back to the first from where it was; where there is none it sits at its stop, which bears Q − N − T κ/R.
"""

from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq
from sources import CLUTCHES
from strategies import direct_specs, indirect_specs, p5

from afmcalc.engines import build
from afmcalc.engines.characteristics import DiscCharacteristic, SetSpring
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, resolved
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import DiscStack

SIZES = {size.name: size for size in discs()}
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
PATIENT = settings(suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
SOFT = "{outer_diameter=0.1, inner_diameter=0.05, thickness=2e-3, free_height=4.8e-3, series=10}"
STEEP = "control_unit.gain_slope=30", "control_unit.key_friction=0.05", "adjustment.method=mean-friction"
OFF, BACK = -1, 1
"""Sign of the key's friction on a sleeve that slides off its stop, and on one that slides back to it."""


def stack(name, series, parallel=1):
    return DiscStack(**{each: getattr(SIZES[name], each) for each in SHAPE}, parallel=parallel, series=series)


@st.composite
def stacks(draw, wanted, spare):
    """A stack of disc springs that bears ``spare`` times the wanted force."""
    name, series = draw(st.sampled_from(["A 40", "B 40", "C 40", "C 100"])), draw(st.integers(2, 12))
    one = DiscCharacteristic(stack(name, series))
    return stack(name, series, int(np.ceil(spare * wanted / float(one.force(one.end))))).model_dump(exclude_none=True)


@st.composite
def sleeves(draw):
    """Indirect clutches with walls, springs, setting and force of every kind."""
    data = resolved(draw(indirect_specs(curved=draw(st.booleans()))))
    assume(data["control_spring"]["stiffness"] > 1e3)
    unit, force = data["control_unit"], data["closing_spring"]["force"]
    if draw(st.booleans()):
        # leaves its stop below, within or above the range
        at, net = draw(st.floats(0.01, 1.0)), float(build(make_spec(data)).net_gain)
        data["control_spring"]["force"] = force * (1 + data["friction_group"]["pairs"] * net * at)
    elif draw(st.booleans()):
        unit.pop("gain_slope", None)
        unit["pocket"] = "constant-torque"
    held = float(build(make_spec(data)).control_force)
    for name, wanted in (("closing_spring", force), ("control_spring", held)):
        if draw(st.booleans()):
            data[name]["disc"] = draw(stacks(wanted, 1.6 if name == "control_spring" else 1.05))
    try:
        return make_spec(data)
    except SpecError:
        assume(False)


class Place(NamedTuple):
    """Place of the sleeve: its travel, and the normal force there."""

    travel: float
    pressed: float


class March:
    """The forces on the sleeve over its travel."""

    def __init__(self, spec, slope):
        unit, own = spec.control_unit, spec.friction.range
        self.z, self.radius = spec.friction_group.pairs, spec.friction_group.mean_radius
        self.gain, self.slope, self.key = unit.gain, slope, 2 * self.radius * unit.key_friction / unit.hub_diameter
        self.force, at = (spec.closing_spring.force, own.mean if spec.adjustment.method == "mean-friction" else own.min)
        made = spec.control_spring.force
        self.control = self.force * (1 + self.z * self.net(0.0, OFF) * at) if made is None else made
        first, second = spec.closing_spring, spec.control_spring
        if first.disc:
            own = DiscCharacteristic(first.disc)
            self.reach = float(own.deflection(self.force))
            self.pressed = lambda x: own.force(self.reach - x)
        else:
            self.reach = self.force / first.stiffness
            self.pressed = lambda x: self.force - first.stiffness * x
        if second.disc:
            other = DiscCharacteristic(second.disc)
            set_at = float(other.deflection(self.control))
            self.pushed = lambda x: other.force(set_at + x)
        else:
            self.pushed = lambda x: self.control + second.stiffness * x
        self.grid = np.linspace(0, self.reach * (1 - 1e-9), 2_001)
        self.needed = {way: self.friction(self.grid, way) for way in (OFF, BACK)}

    def net(self, x, way):
        return self.gain + way * self.key + self.slope * x

    def friction(self, x, way):
        """Friction at which the forces on the sleeve balance."""
        return (self.pushed(x) / self.pressed(x) - 1) / (self.z * self.net(x, way))

    def rising(self, f):
        """First place whose friction is not below ``f`` as friction rises; None if rounding errors decide."""
        needed = self.needed[OFF]
        if self._is_close(needed, f):
            return None
        return self._between(f, OFF, np.flatnonzero(needed >= f), after=True)

    def returning(self, f, start, top):
        """Place as friction falls from ``top``, which put the sleeve at ``start``; the key holds it there at first."""
        if f * self.net(start.travel, BACK) >= top * self.net(start.travel, OFF):
            return start
        needed = self.needed[BACK]
        if self._is_close(-needed, -f):
            return None
        return self._between(f, BACK, np.flatnonzero((needed <= f) & (self.grid < start.travel))[::-1], after=False)

    def _is_close(self, needed, f):
        """True if the sleeve is about to leave its stop, or to jump."""
        tops = needed[1:-1][(np.diff(needed)[:-1] > 0) & (np.diff(needed)[1:] < 0)]
        return np.abs(np.append(tops, needed[0]) / f - 1).min() < 1e-4

    def _between(self, f, way, places, *, after):
        """The first of ``places``, refined to rounding; the stop if there is none."""
        if (after and places[0] == 0) or not places.size:
            return Place(0.0, self.control / (1 + self.z * self.net(0.0, way) * f))
        low, high = (self.grid[places[0] + step] for step in ((-1, 0) if after else (0, 1)))
        at = brentq(lambda x: self.friction(x, way) - f, low, high, xtol=1e-13 * self.reach)
        return Place(at, float(self.pressed(at)))


@PATIENT
@given(sleeves())
@example(p5(*STEEP))  # jumps off its stop, and back to it
@example(p5(*STEEP, f"closing_spring.disc={SOFT}"))
@example(p5(f"closing_spring.disc={SOFT}", "adjustment.method=mean-friction"))
def test_the_first_place_that_holds_the_sleeve(spec):
    clutch = build(spec)
    march, own = March(spec, clutch.get("gain_slope", 0.0)), clutch.spec.friction.groups[0]
    assert clutch.control_force == pytest.approx(march.control)
    assert clutch.pack_force_at_rest == pytest.approx(march.control), "the balls bear nothing"
    for f in own.min + (own.max - own.min) * np.linspace(0.01, 1, 4):
        if (at := march.rising(f)) is None:
            continue
        torque = march.z * march.radius * f * at.pressed
        assert clutch.at(friction=f)["travel"] == pytest.approx(at.travel, rel=1e-6, abs=1e-7 * march.reach)
        assert clutch.at(friction=f)["torque"] == pytest.approx(torque, rel=1e-6)
        assert clutch.at(friction=f)["release_force"] == pytest.approx(
            torque * (march.gain + march.slope * at.travel) / march.radius
        )
        borne = at.pressed - march.pressed(at.travel)
        assert clutch.at(friction=f)["stop_reaction"] == pytest.approx(borne, abs=1e-6 * march.control)
        left = march.pushed(at.travel) - at.pressed - torque * march.net(at.travel, OFF) / march.radius
        assert left == pytest.approx(0, abs=1e-6 * march.control)
    assume(at is not None)
    for f in np.geomspace(0.97 * own.max, 0.97 * own.min, 8):
        if (back := march.returning(f, at, own.max)) is None:
            continue
        assert clutch.at(friction=f)["torque_returning"] == pytest.approx(
            march.z * march.radius * f * back.pressed, rel=1e-6
        )
        if spec.spring_parts and "gain_slope" in clutch:
            assert clutch.at(friction=f)["travel_returning"] == pytest.approx(
                back.travel, rel=1e-6, abs=1e-7 * march.reach
            )


def seated(low):
    """Key friction makes κ 2 and κ₊ 4; the sleeve would only leave its stop at f = 1, above f_max = 0.5."""
    unit = {"gain": 3.0, "gain_slope": 40.02, "key_friction": 0.3, "hub_diameter": 0.03, "ball_circle_radius": 0.05}
    disc = stack("A 40", 4).model_dump(exclude_none=True)
    return make_spec({
        "variant": "indirect",
        "friction": {"min": low, "mean": low, "max": 0.5},
        "friction_group": {"pairs": 1, "mean_radius": 0.05},
        "closing_spring": {"force": 500.0, "stiffness": 2000.0},
        "control_spring": {"stiffness": 1000.0, "force": 1500.0, "disc": disc},
        "control_unit": {**unit, "balls": 6},
    })  # fmt: skip


@pytest.mark.parametrize("low", [0.5, 0.4, 0.25, 0.1])
def test_a_sleeve_that_never_left_its_stop_does_not_return(low):
    """The key keeps N = F_п2/(1 + z κ f_max) = 750 N down to f_max κ/κ₊ = 0.25; below, N = F_п2/(1 + z κ₊ f)."""
    clutch = build(seated(low))
    assert clutch.travel_max == 0
    pressed = max(1500 / (1 + 2 * 0.5), 1500 / (1 + 4 * low))
    assert clutch.torque_returning_min == pytest.approx(0.05 * low * pressed, rel=1e-12)


UNLIKE = direct_specs(variants=("unlike", "differentiated", "all-driving"))


@PATIENT
@given(st.one_of(sleeves(), sleeves(), UNLIKE))
def test_no_friction_gives_more_or_less_and_a_step_aside_gives_as_much(spec):
    clutch = own = build(spec)
    path = clutch.path(np.append(np.linspace(0.0, 1.0, 4_001), own.get("bend_of_path", 0.0)))
    swept, first = np.asarray(clutch.at_friction(*path)["torque"]), clutch.spec.friction.groups[0]
    low, high = float(swept.min()), float(swept.max())
    bent = spec.spring_parts and "gain_slope" in clutch  # before a jump the torque changes ever more steeply
    apart = 5e-3 if bent else 1e-3  # relative distance between an extreme and the nearest point of the grid
    assert low * (1 - apart) <= own.torque_min <= low * (1 + 1e-9)
    assert high * (1 + apart) >= own.torque_max >= high * (1 - 1e-9)
    assert clutch.scatter == pytest.approx(own.torque_max - own.torque_min, rel=1e-9, abs=1e-12 * high)
    assert clutch.accuracy_factor == pytest.approx(own.torque_max / own.torque_min, rel=1e-9)
    for at, extreme in ((own.friction_of_torque_min, own.torque_min), (own.friction_of_torque_max, own.torque_max)):
        assert first.min * (1 - 1e-9) <= at <= first.max * (1 + 1e-9)
        # within slightly more than a step on either side, because a jump may lie just there
        step = (first.max - first.min) / 4e3 + 1e-9
        near = np.clip(at + step * np.linspace(-1, 1, 4_001), first.min, first.max)
        torques = [low, high] if spec.friction.unlike else clutch.at(friction=near)["torque"]
        assert np.min(np.abs(np.asarray(torques) / extreme - 1)) < (1e-4 if bent else 1e-6)
    if spec.kind.travels:
        back = float(np.min(clutch.at(friction=path[0])["torque_returning"]))
        assert clutch.torque_returning_min <= min(back, own.torque_min) * (1 + 1e-9)
        assert clutch.torque_returning_min == pytest.approx(back, rel=2e-2)
        assert clutch.accuracy_factor_hysteresis == pytest.approx(
            own.torque_max / clutch.torque_returning_min, rel=1e-9
        )


def test_a_pocket_cut_for_disc_springs_nearly_holds_the_torque():
    disc = f"closing_spring.disc={{{', '.join(f'{name}={value}' for name, value in stack('B 40', 6) if value is not None)}}}"
    own = "closing_spring.stiffness=4e5", "control_spring.stiffness=2e5", "C=2", "control_unit.key_friction=0.01"
    clutch = build(p5(*own, disc, "control_unit.pocket=constant-torque"))
    assert clutch.at(friction=0.8)["torque"] == pytest.approx(clutch.at(friction=0.1)["torque"], rel=1e-9), (
        "the same at both ends"
    )
    swept = clutch.at(friction=np.linspace(0.1, 0.8, 10_001))["torque"]
    assert clutch.torque_min == pytest.approx(swept.min(), rel=1e-9), "between them"
    assert clutch.at(friction=0.8)["torque"] / 1.03 < clutch.torque_min < clutch.at(friction=0.8)["torque"] / 1.001


def test_a_jump_between_disc_springs_is_seen_from_both_sides():
    """Where the discs give way, far from the stop, the largest torque lies just before the jump, the smallest after."""
    own = clutch = build(CLUTCHES["jump"])
    assert own.friction_of_torque_min == pytest.approx(own.friction_of_torque_max, rel=1e-9)
    assert own.torque_max == pytest.approx(
        float(clutch.at(friction=own.friction_of_torque_max * (1 - 1e-9))["torque"]), rel=1e-6
    )
    assert own.torque_min == pytest.approx(
        float(clutch.at(friction=own.friction_of_torque_min * (1 + 1e-9))["torque"]), rel=1e-6
    )
    assert own.torque_min < 0.2 * own.torque_max


@pytest.mark.parametrize("disc", [None, DiscCharacteristic(stack("B 40", 20))])
def test_a_set_spring_slackens_to_a_force_and_grows_by_its_stiffness(disc):
    spring = SetSpring(2000.0, 4e4 if disc is None else disc.stiffness(disc.deflection(2000.0)), disc)
    assert float(spring.force(0.0)) == pytest.approx(2000)
    for force in (500.0, 1000.0, 1999.0):
        assert float(spring.force(-spring.slackens(force))) == pytest.approx(force, rel=1e-9)
    # a spring that extends by its whole deflection has no force left
    assert float(spring.force(-spring.deflection)) == pytest.approx(0, abs=1e-9)
    for further in (-1e-3, 5e-4):
        slope = (float(spring.force(further + 1e-7)) - float(spring.force(further - 1e-7))) / 2e-7
        assert float(spring.stiffness(further)) == pytest.approx(slope, rel=1e-6)
