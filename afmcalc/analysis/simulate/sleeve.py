"""Discs, springs, key and balls of an indirect clutch at one friction, as the drive meets them."""

from dataclasses import dataclass
from functools import cached_property

from ...arrays import V, Values, chosen
from ...equations import direct, indirect, sleeve


@dataclass(frozen=True)
class Sleeve:
    """Discs, springs, key and balls of an indirect clutch at one friction; numbers, or arrays in a sweep."""

    friction_pairs: float
    """z f."""
    mean_radius: float
    gain: float
    net_gain: float
    """κ."""
    net_gain_returning: float
    """κ₊."""
    closing_force: float
    control_force: float
    closing_stiffness: float
    control_stiffness: float
    mass: float = 0.0
    static_ratio: float = 1.0
    decay_rate: float = 0.0

    def moment(self, travel: V) -> V:
        """S(x), N·m."""
        springs = self.closing_force, self.control_force, self.closing_stiffness, self.control_stiffness
        moment: V = sleeve.spring_moment(self.mean_radius, *springs, travel)
        return moment

    def work(self, travel: V) -> V:
        """Work stored in both springs, J."""
        springs = self.closing_force, self.control_force, self.closing_stiffness, self.control_stiffness
        work: V = sleeve.spring_work(*springs, travel)
        return work

    def travel(self, turn: V) -> V:
        """Travel for a turn either way, m."""
        travel: V = sleeve.travel(abs(turn), self.mean_radius, self.gain)
        return travel

    def pressed_at_stop(self, ball_torque: V, net_gain: float) -> V:
        """N at the stop for a gain κ or κ₊, N."""
        force: V = sleeve.normal_force_at_stop(self.control_force, net_gain, abs(ball_torque), self.mean_radius)
        return force

    def torque(self, ratio: float, net_gain: float) -> Values:
        """Slip torque that lasts with friction times ``ratio``, the key counted in the gain κ or κ₊, N·m."""
        pairs = self.friction_pairs * ratio
        off = self.control_force < self.closing_force * (1 + pairs * net_gain)
        stiffness = indirect.sleeve_stiffness(self.closing_stiffness, self.control_stiffness, pairs, 1.0, net_gain)
        springs = self.closing_force, self.closing_stiffness, self.control_force, self.control_stiffness
        normal = chosen(
            off,
            lambda: indirect.normal_force_moving(*springs, stiffness),
            lambda: indirect.normal_force_seated(self.control_force, 1.0, net_gain, pairs),
        )
        torque: Values = direct.group_torque(normal, self.mean_radius, 1.0, pairs)
        return torque

    @cached_property
    def lift(self) -> float:
        """Torque at which the sleeve leaves its stop, S(0)/κ."""
        return self.moment(0.0) / self.net_gain
