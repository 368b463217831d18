"""Engine of indirect regulation: a thrust sleeve between two springs, friction at its key (S21)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from ..equations import accuracy, indirect, pocket
from ..equations.arrays import Values, chosen, is_array, larger, quiet_division, smaller, square_root
from ..findings import Finding, finding
from ..messages import say
from ..spec.models import Method, Spec
from . import parameters
from .direct import both_frictions
from .protocol import Clutch, TorqueAt, extremes
from .springs import DiscCharacteristic, SetSpring

if TYPE_CHECKING:
    from .balance import Balance

_ROUNDING = 1e-12


@dataclass(frozen=True)
class IndirectClutch(Clutch):
    """Clutch whose release force slackens the closing spring by way of a sleeve; all torque passes the balls."""

    closing_stiffness: Values
    """c_1, N/m."""
    control_stiffness: Values
    """c_2, N/m."""
    key_friction: Values
    """f_1 at the key."""
    hub_diameter: Values
    """d, m."""
    friction_set: Values
    """Friction at which the control spring is set so that the sleeve just stays at its stop."""
    made_control_force: Values | None = None
    """F_п2 as made, N; None where it is set by S21 (14)."""
    closing_disc: DiscCharacteristic | None = None
    """The closing spring where its force is not proportional to its deflection; None where it is straight."""
    control_disc: DiscCharacteristic | None = None
    """The control spring where its force is not proportional to its deflection; None where it is straight."""
    gain_slope: Values = 0.0
    """C_1, 1/m: growth of the gain per travel of the sleeve; 0 for a straight wall (handbook, chapter 12)."""

    @classmethod
    def from_spec(cls, spec: Spec) -> "IndirectClutch":
        """Build the engine of a spec whose values may be arrays.

        Raises:
            SpecError: a gain below the threshold 2 R f_1/d, or no wall that holds the torque.
        """
        # the rules of the spec require these blocks and their values
        unit: Any = spec.control_unit
        closing: Any = spec.closing_spring
        control: Any = spec.control_spring
        friction, pairs, radius = parameters.frictions(spec), spec.friction_group.pairs, parameters.mean_radius(spec)
        friction_set, _ = parameters.at_setting(friction, spec)
        clutch = cls(
            closing_force=parameters.closing_force(
                spec, lambda: indirect.torque_per_force(pairs, radius, friction_set)
            ),
            mean_radius=radius,
            bypass_pairs=0,
            controlled_pairs=pairs,
            gain=parameters.feedback_gain(spec),
            friction=friction,
            spec=spec,
            closing_stiffness=closing.stiffness,
            control_stiffness=control.stiffness,
            key_friction=unit.key_friction,
            hub_diameter=unit.hub_diameter,
            friction_set=friction_set,
            made_control_force=control.force,
            closing_disc=closing.disc and DiscCharacteristic(closing.disc),
            control_disc=control.disc and DiscCharacteristic(control.disc),
            gain_slope=0.0 if unit.gain_slope is None else unit.gain_slope,
        )
        clutch._refuse_negative_net_gain()
        if unit.pocket != "constant-torque":
            return clutch
        return replace(clutch, gain_slope=clutch._slope_that_holds_the_torque())

    def _refuse_negative_net_gain(self) -> None:
        """Refuse a gain below the threshold, at which the sleeve would leave its stop at zero torque."""
        net = self.net_gain
        if not _where_least(net, net) < 0:
            return
        threshold, gain = (_where_least(net, value) for value in (self.gain_threshold, self.gain))
        message = say(
            "must be at least 2 R f_1/d = {threshold:.6g}: below that the friction at the key exceeds the release "
            "force, and the sleeve leaves its stop at zero torque",
            threshold=threshold,
        )
        path = parameters.gain_path(self.spec)
        given = f"{gain:.6g}" if path == "control_unit.gain" else f"(C = {gain:.6g})"
        raise self.spec.refused(path, message, given)

    def _slope_that_holds_the_torque(self) -> Values:
        leaving = self.leaving_friction
        if not is_array(leaving) and not leaving > 0:
            message = say(
                "no wall holds the torque: control_spring.force does not exceed the force of the closing spring, so "
                "that the sleeve never rests at its stop"
            )
            raise self.spec.refused("control_unit.pocket", message, repr("constant-torque"))
        return chosen(leaving > 0, lambda: self.constant_torque_slope, lambda: math.nan)

    @property
    def sleeve(self) -> "IndirectClutch":
        """The clutch itself, as it has a sleeve."""
        return self

    @property
    def pairs(self) -> Values:
        """z."""
        return self.controlled_pairs

    @property
    def reduced_gain(self) -> Values:
        """z C."""
        return self.pairs * self.gain

    # gains

    @property
    def straight(self) -> bool:
        """Whether the walls are straight, so that the gain does not depend on the travel."""
        return not is_array(self.gain_slope) and bool(self.gain_slope == 0)

    @property
    def gain_threshold(self) -> Values:
        """2 R f_1/d: the gain at which feedback begins."""
        return indirect.gain_threshold(self.mean_radius, self.key_friction, self.hub_diameter)

    def gain_at(self, travel: Values) -> Values:
        """C at a travel of the sleeve."""
        return self.gain if self.straight else pocket.gain_at(self.gain, self.gain_slope, travel)

    @property
    def net_gain(self) -> Values:
        """κ at the stop, for a sleeve that moves off the stop."""
        return indirect.net_gain(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)

    @property
    def net_gain_returning(self) -> Values:
        """κ₊ at the stop, for a sleeve that moves back."""
        return indirect.net_gain_returning(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)

    def steepened(self, travel: Values) -> "IndirectClutch":
        """The same clutch with the gain that it has at a travel of the sleeve."""
        return self if self.straight else replace(self, gain=self.gain_at(travel))

    @property
    def equivalent_gain(self) -> Values | None:
        """Gain of the all-driving clutch with the same torque curve; None with curved springs or pockets."""
        if self.curved or not self.straight:
            return None
        return indirect.equivalent_gain(self.net_gain, self.closing_stiffness, self.control_stiffness)

    # springs

    @property
    def curved(self) -> bool:
        """Whether the force of a spring is not proportional to its deflection."""
        return self.closing_disc is not None or self.control_disc is not None

    @cached_property
    def closing_spring(self) -> SetSpring:
        """The closing spring as it is set."""
        return SetSpring(self.closing_force, self.closing_stiffness, self.closing_disc)

    @cached_property
    def control_spring(self) -> SetSpring:
        """The control spring as it is set."""
        return SetSpring(self.control_force, self.control_stiffness, self.control_disc)

    @property
    def following_spring(self) -> SetSpring:
        """The control spring: as the pack wears, sleeve and closing spring move along with the pressure disc.

        The stop is a part of the pressure disc, so that only the control spring extends.
        """
        return SetSpring(self.pack_force_at_rest, self.control_stiffness, self.control_disc)

    @property
    def control_force(self) -> Values:
        """F_п2, N: as made, or by S21 (14)."""
        if self.made_control_force is not None:
            return self.made_control_force
        return indirect.control_force(self.closing_force, self.pairs, self.net_gain, self.friction_set)

    @property
    def pack_force_at_rest(self) -> Values:
        """Force on the pack of the clutch at rest, N: the control spring's, which acts through sleeve and stop."""
        return self.normal_force(0.0)

    def torque_per_force(self, method: Method | None = None) -> Values:
        """T/F_п1 at the setting, m, where the closing spring alone presses the pack."""
        friction = self.friction_set if method is None else self.friction_at_setting(method)[0]
        return indirect.torque_per_force(self.pairs, self.mean_radius, friction)

    # the stop

    @property
    def leaving_friction(self) -> Values:
        """Friction at which the sleeve leaves its stop; the torque curve has a kink there."""
        made = self.made_control_force
        if made is None:
            return self.friction_set
        net = self.net_gain
        if not is_array(net) and net == 0:
            # the balls do not move the sleeve: it stays at its stop at every friction, or at none
            return chosen(made >= self.closing_force, lambda: math.inf, lambda: -math.inf)
        with quiet_division(net):  # in arrays the division by κ = 0 gives ±inf as well
            return pocket.leaving_friction(self.closing_force, made, self.pairs, net)

    def is_seated(self, friction: Values) -> Any:
        """Whether the sleeve is at its stop, friction rising: the control spring exceeds closing spring and balls."""
        # at the leaving friction both laws give the same force, unless the sleeve jumps off a steep curved wall
        return friction < self.leaving_friction if self.straight else friction <= self.leaving_friction

    def _holds(self, friction: Values, net_gain: Values) -> Any:
        """Whether the control spring keeps a sleeve at its stop."""
        return self.control_force > self.closing_force * (1 + self.pairs * net_gain * friction)

    def _is_reseated(self, friction: Values, locked: Values) -> Any:
        """Whether the sleeve is back at its stop, friction falling; ``locked``: normal force before the return.

        On a wall so steep that the sleeve jumps off its stop, the sleeve also stays off until it jumps back.
        """
        net = self.net_gain_returning
        can_seat = self._holds(friction, net)
        if self.straight:
            return can_seat
        weight = pocket.slope_feedback(self.pairs, friction, self.gain_slope) * self.closing_force
        jumped = (self._straight_stiffness(friction, net) < weight) & (locked < self.closing_force)
        stays_off = jumped & (self._squared(friction, net) >= 0)
        return chosen(stays_off, lambda: False, lambda: can_seat)

    # pockets

    @property
    def constant_torque_slope(self) -> Values:
        """C_1* at which torque would not depend on friction once the sleeve is off its stop, 1/m."""
        return self.slope_that_holds(self.friction[0].max)

    def slope_that_holds(self, friction_max: Values) -> Values:
        """C_1* at which torque does not depend on friction once the sleeve is off its stop, 1/m.

        With disc springs no C_1 does so exactly: this one gives equal torques at ``friction_max`` and leaving friction.
        """
        leaving = self.leaving_friction
        stiffness = self.closing_stiffness, self.control_stiffness
        if self.curved:
            # a friction a little above the leaving friction at least, so that the travel is not 0
            slackened = self.closing_force * leaving / larger(friction_max, leaving * (1 + 1e-6))
            travel = self.closing_spring.slackens(slackened)
            stiffness = self.closing_spring.secant(-travel), self.control_spring.secant(travel)
        return pocket.constant_torque_slope(*stiffness, self.pairs, leaving, self.closing_force)

    @property
    def jumping_slope(self) -> Values:
        """C_1 above which the sleeve jumps off its stop as friction rises, 1/m."""
        leaving = self.leaving_friction
        stiffnesses = self.closing_spring.stiffness(0.0), self.control_spring.stiffness(0.0)
        stiffness = indirect.sleeve_stiffness(*stiffnesses, self.pairs, leaving, self.net_gain)
        return pocket.jumping_slope(stiffness, self.pairs, leaving, self.closing_force)

    # off the stop

    def _straight_stiffness(self, friction: Values, net_gain: Values) -> Values:
        """D(f) with the gain of the stop, N/m."""
        springs = self.closing_stiffness, self.control_stiffness
        return indirect.sleeve_stiffness(*springs, self.pairs, friction, net_gain)

    def _squared(self, friction: Values, net_gain: Values) -> Values:
        """k_t², N²/m²; negative where no travel off the stop is in balance."""
        return pocket.tangent_stiffness_squared(
            self.closing_force,
            self.closing_stiffness,
            self.control_force,
            self.control_stiffness,
            self._straight_stiffness(friction, net_gain),
            pocket.slope_feedback(self.pairs, friction, self.gain_slope),
        )

    def tangent_stiffness(self, friction: Values, net_gain: Values) -> Values:
        """k_t, N/m: stiffness of the balance at the travel of a sleeve off its stop; D(f) for a straight pocket."""
        if self.straight:
            return self._straight_stiffness(friction, net_gain)
        # where the sleeve is about to jump, rounding may make the square negative
        return square_root(larger(self._squared(friction, net_gain), 0.0))

    def _pressed_at_stop(self, friction: Values, net_gain: Values) -> Values:
        """F_п2/(1 + zκf), N."""
        return indirect.normal_force_seated(self.control_force, self.pairs, net_gain, friction)

    def _pressed_off_stop(self, friction: Values, net_gain: Values) -> Values:
        """Normal force with the sleeve in balance off its stop, N (S21 (9))."""
        if self.curved:
            balance = self.balance(net_gain)
            return balance.normal_force(friction, balance.travel(friction))
        springs = self.closing_force, self.closing_stiffness, self.control_force, self.control_stiffness
        stiffness = self._straight_stiffness(friction, net_gain)
        if not self.straight:
            slope = pocket.slope_feedback(self.pairs, friction, self.gain_slope)
            tangent = self.tangent_stiffness(friction, net_gain)
            stiffness = pocket.sleeve_stiffness(stiffness, self.closing_force, slope, tangent)
        force = indirect.normal_force_moving(*springs, stiffness)
        return smaller(self.closing_force, force)

    def balance(self, net_gain: Values) -> "Balance":
        """Balance of the forces on a sleeve off its stop, with these springs and walls."""
        from .balance import Balance

        for spring in (self.closing_spring, self.control_spring):
            if spring.disc is not None:
                _ = spring.deflection  # here `explain` lists it; in the search for the balance it does not
        return Balance(self.closing_spring, self.control_spring, self.pairs, net_gain, self.gain_slope, self.straight)

    # friction rising

    def normal_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Normal force N on the pairs, N: from F_п2 at rest down to F_п1 at the setting, then by S21 (9)."""
        friction = _one_friction(friction, friction_driven)
        return chosen(
            self.is_seated(friction),
            lambda: self._pressed_at_stop(friction, self.net_gain),
            lambda: self._pressed_off_stop(friction, self.net_gain),
        )

    def torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Slip torque T, N·m, friction rising (S21 (11); at the stop a direct clutch of gain κ)."""
        return indirect.torque(self.normal_force(friction, friction_driven), self.mean_radius, self.pairs, friction)

    def ball_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Torque that passes the balls, N·m: all of it."""
        return self.torque(friction, friction_driven)

    def release_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Release force F_p of the balls on the sleeve, N."""
        gain = self.gain if self.straight else self.gain_at(self.travel(friction))
        return indirect.release_force(self.torque(friction, friction_driven), gain, self.mean_radius)

    def stop_reaction(self, friction: Values) -> Values:
        """Reaction S of the stop on the sleeve, N, friction rising; 0 once the sleeve has left it."""
        return chosen(
            self.is_seated(friction),
            lambda: indirect.stop_reaction(
                self.control_force, self.closing_force, self.torque(friction), self.net_gain, self.mean_radius
            ),
            lambda: 0.0,
        )

    @property
    def travel_max(self) -> Values:
        """x_max at f_max, m."""
        return self.travel(self.friction[0].max)

    def travel(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Axial travel x of the sleeve, m; 0 at the stop (S21 (10), (16))."""
        friction = _one_friction(friction, friction_driven)
        return chosen(self.is_seated(friction), lambda: 0.0, lambda: self._travelled(friction))

    def _travelled(self, friction: Values) -> Values:
        net, made = self.net_gain, self.made_control_force
        if self.curved:
            return self.balance(net).travel(friction)
        if not self.straight:
            return pocket.travel(self.closing_force, self.normal_force(friction), self.closing_stiffness)
        stiffness = self._straight_stiffness(friction, net)
        if made is None:
            return indirect.travel(self.pairs, self.closing_force, friction, self.friction_set, net, stiffness)
        return indirect.travel_as_made(self.closing_force, made, self.pairs, friction, net, stiffness)

    # friction falling

    def torque_returning(self, friction: Values, friction_max: Values | None = None) -> Values:
        """Torque when friction falls from ``friction_max``, by default f_max, under load, N·m (handbook, chapter 5).

        The key keeps the sleeve in its place until f has fallen by a factor of κ₊/κ; then the sleeve moves back.
        """
        friction, most = _one_friction(friction, None), self.friction[0].max if friction_max is None else friction_max
        locked = self.normal_force(most)
        is_locked = self._is_locked(friction, most, locked)
        pressed = chosen(is_locked, lambda: locked, lambda: self._pressed_returning(friction, most, locked))
        return indirect.torque(pressed, self.mean_radius, self.pairs, friction)

    def _is_locked(self, friction: Values, friction_max: Values, locked: Values) -> Any:
        """Whether the key still keeps the sleeve where it was at ``friction_max`` and normal force ``locked``."""
        steeper: Values = 0.0
        if not self.straight:
            travel = self.travel(friction_max) if self.curved else larger(self.closing_spring.slackens(locked), 0.0)
            steeper = self.gain_slope * travel
        lifting = friction_max * (self.net_gain + steeper)
        return friction * (self.net_gain_returning + steeper) >= lifting * (1 - _ROUNDING)

    def _pressed_returning(self, friction: Values, friction_max: Values, locked: Values) -> Values:
        """Normal force when the sleeve moves back, or is back at its stop, N."""
        net = self.net_gain_returning
        if self.curved and not self.straight:
            travel = self.travel_returning(friction, friction_max)
            return chosen(
                (travel <= 0) & self._holds(friction, net),
                lambda: self._pressed_at_stop(friction, net),
                lambda: self.balance(net).normal_force(friction, travel),
            )
        return chosen(
            self._is_reseated(friction, locked),
            lambda: self._pressed_at_stop(friction, net),
            lambda: self._pressed_off_stop(friction, net),
        )

    def travel_returning(self, friction: Values, friction_max: Values | None = None) -> Values:
        """Travel when friction falls from ``friction_max``, by default f_max, m; for curved springs or walls."""
        most = self.friction[0].max if friction_max is None else friction_max
        return self.balance(self.net_gain_returning).travel_returning(friction, self.travel(most))

    @property
    def torque_returning_min(self) -> Values:
        """Smallest torque as friction falls from f_max to f_min under load, N·m.

        It occurs at f_min, unless a curved pocket lets the torque rise while the sleeve returns.
        """
        friction = self.friction[0]
        least = self.torque_returning(friction.min)
        if self.straight:
            return least
        least = smaller(least, self.torque_returning(larger(friction.max / self.hysteresis_ratio, friction.min)))
        if not self.curved:
            return least
        ends = self.travel_max, self.travel_returning(friction.min)
        turning = self._turns(ends, self.net_gain_returning, friction.min)[0][0]
        # a sleeve that f_max leaves at its stop does not return: the stop still bears a part of the control spring
        return chosen(ends[0] > 0, lambda: smaller(least, turning), lambda: least)

    @property
    def hysteresis_ratio(self) -> Values:
        """Factor by which friction must fall from f_max before the sleeve returns: κ₊/κ at the travel of the sleeve."""
        there = self if self.straight else self.steepened(self.travel_max)
        return indirect.hysteresis_ratio(there.net_gain, there.net_gain_returning)

    # over the range

    @property
    def accuracy_factor(self) -> Values:
        """K_т (S21 (15), with the stop)."""
        if self.made_control_force is not None or self.curved or not self.straight:
            return accuracy.accuracy_factor_of_torques(self.torque_max, self.torque_min)
        first = self.friction[0]
        springs = self.closing_stiffness, self.control_stiffness
        return indirect.accuracy_factor(first.min, self.friction_set, first.max, *springs, self.pairs, self.net_gain)

    @property
    def accuracy_factor_hysteresis(self) -> Values:
        """K_т under a lasting load: friction falls from f_max to f_min, and the key delays the return of the sleeve."""
        return indirect.accuracy_factor_hysteresis(self.torque_max, self.torque_returning_min)

    def extreme_torques(self, start: Literal["min", "mean"] = "min") -> tuple[TorqueAt, TorqueAt]:
        """Points of smallest and largest torque: the ends of the range; with a curved pocket perhaps points between."""
        low, high = getattr(self.friction[0], start), self.friction[0].max
        first, last = (self.torque(low), low), (self.torque(high), high)
        if self.straight:
            return first, last
        leaving = smaller(larger(self.leaving_friction, low), high)
        between: list[TorqueAt] = []
        if self.curved:  # with curved springs and walls the torque may be extreme at any friction
            between = self._turns((self.travel(low), self.travel(high)), self.net_gain, low)
        return extremes([first, (self.torque(leaving), leaving), *between, last])

    def _turns(self, ends: tuple[Values, Values], net_gain: Values, low: Values) -> list[TorqueAt]:
        """Points of smallest and largest torque between two travels of the sleeve, at frictions from ``low`` on."""
        import numpy as np

        balance, high = self.balance(net_gain), self.friction[0].max
        # zeros in the common shape of all clutches, as the travels may have a smaller shape
        shape = 0.0 * (self.closing_force * self.control_force * net_gain * self.gain_slope)
        way = balance.way(*(end + shape for end in ends))
        friction = np.asarray(balance.friction(way))
        torque = indirect.torque(balance.pressed(way), self.mean_radius, self.pairs, friction)
        inside = (friction >= low * (1 - _ROUNDING)) & (friction <= high * (1 + _ROUNDING))
        torque, friction = np.where(inside, torque, self.torque(high)), np.where(inside, friction, high)
        turns = (
            [np.take_along_axis(values, place[None], axis=0)[0] for values in (torque, friction)]
            for place in (torque.argmin(axis=0), torque.argmax(axis=0))
        )
        return [(one, two) if way.ndim > 1 else (float(one), float(two)) for one, two in turns]

    @property
    def nominal_torque_ratio(self) -> Values:
        """K_п against the base clutch of equal spring and gain, all pairs controlled."""
        at_setting = self.pairs, self.gain, self.friction_set
        if self.made_control_force is None:
            return indirect.nominal_torque_ratio(*at_setting)
        pressed = self.normal_force(self.friction_set)
        return indirect.nominal_torque_ratio_as_made(*at_setting, pressed, self.closing_force)

    # findings

    def _law_findings(self) -> Iterator[Finding]:
        """Findings on curved springs, idle feedback, the key's hysteresis, and a pocket in which the torque falls."""
        if self.curved:
            path = "control_spring.disc" if self.closing_disc is None else "closing_spring.disc"
            yield finding("curved-springs", "info", path=path)
        if self.net_gain == 0:
            path, gain, threshold = parameters.gain_path(self.spec), float(self.gain), float(self.gain_threshold)
            yield finding("feedback-idle/key", "warning", value=gain, limit=threshold, path=path)
            return
        yield from self._slope_findings()
        if self.key_friction:
            yield from self._key_findings()

    def _slope_findings(self) -> Iterator[Finding]:
        """Finding where C_1 exceeds C_1*: a load that reaches T_н makes the sleeve run off, and the torque falls."""
        slope, friction = float(self.gain_slope), self.friction[0].max
        if slope == 0 or not 0 < self.leaving_friction < friction:
            return
        best, jumping = float(self.constant_torque_slope), float(self.jumping_slope)
        if slope > best * (1 + 1e-9):
            code = "torque-jumps" if slope > jumping else "torque-falls-with-travel"
            most, falls = float(self.torque(float(self.leaving_friction))), float(self.torque(friction))
            path = "control_unit.gain_slope"
            yield finding(code, "warning", value=slope, limit=best, path=path, jumping=jumping, most=most, falls=falls)

    def _key_findings(self) -> Iterator[Finding]:
        """Findings on the hysteresis by the key; a warning where the torque may fall below that of the machine."""
        returning, nominal, machine = map(float, (self.torque_returning_min, self.nominal_torque, self.machine_torque))
        key = "control_unit.key_friction"
        yield finding("hysteresis", "info", value=float(self.hysteresis_ratio), limit=1.0, path=key)
        if returning < machine * (1 - 1e-12):
            yield finding("returning-below-nominal", "warning", value=returning, limit=nominal, path=key)
        elif returning < nominal * (1 - 1e-12):
            yield finding("returning-covered", "info", value=returning, limit=nominal, path=key, machine=machine)


def _one_friction(friction: Values, friction_driven: Values | None) -> Values:
    """The one friction of all pairs, checked.

    Raises:
        ValueError: negative or no number, or two different ones.
    """
    first, second = both_frictions(friction, friction_driven)
    same = first is second or first == second
    if not (bool(same.all()) if is_array(same) else same):
        raise ValueError(say("an indirect clutch has one friction for all pairs"))
    return first


def _where_least(value: Values, other: Values) -> float:
    """Return ``other`` where ``value`` is smallest, so that both numbers of a message belong to the same clutch."""
    if not is_array(value):
        return float(other)
    import numpy as np

    return float(np.broadcast_to(other, np.shape(value)).flat[int(np.argmin(value))])
