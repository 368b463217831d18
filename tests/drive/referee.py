"""A second program of the drive: the elements of theory, sections 9 and 12, in small fixed steps; no code of afmcalc.

A direct clutch is the Modelica Standard Library's ``Clutch`` with μ(v) = f/(1 + z_2 C f), cgeo = z R and fn_max = F_п; an
indirect one is pack, hub, balls and driven half in series. Speeds take a step with the positions of its middle, friction
by projection: an element sticks where the torque that stops it is within its bounds.
"""

from math import copysign, exp, inf, sqrt
from typing import Any, NamedTuple


class Event(NamedTuple):
    peak_torque: float
    peak_torque_clutch: float
    slip_time: float
    slip_energy: float
    travel_max: float
    slips_at_end: bool


class Direct:
    """Pack between motor side and driven half; with a release lag its normal force follows with a delay."""

    def __init__(self, spec: dict[str, Any], friction: list[float]):
        group, law, unit = spec["friction_group"], spec["friction"], spec.get("control_unit", {})
        self.z, self.R, self.C = group["pairs"], group["mean_radius"], unit.get("gain", 0.0)
        self.z1 = {"all-driving": 0, "differentiated": group.get("driving_pairs", 1)}.get(spec["variant"], self.z)
        self.z2, self.f1, self.f2 = self.z - self.z1, friction[0], friction[-1]
        self.excess, self.stribeck = law.get("static_ratio", 1.0) - 1, law.get("stribeck_speed", 1.0)
        self.J1, self.J2 = spec["drive"]["motor_inertia"], spec["drive"]["driven_inertia"]
        self.lag, self.x, self.force, own = unit.get("release_lag", 0.0), 0.0, 1.0, spec["adjustment"]
        name, margin = ("mean", own["margin"]) if own.get("method") == "mean-friction" else ("min", 1.0)
        self.set = [law.get(pairs, law)[name] for pairs in ("driving", "driven")]
        self.force = margin * own["nominal_torque"] / self.torque(*self.set)

    def torque(self, f1: float, f2: float) -> float:
        return self.force * self.R * (self.z1 * f1 + self.z2 * f2) / (1 + self.C * self.z2 * f2)

    def ratio(self, v: float) -> float:
        """Friction at a slip speed, over the friction of fast slip."""
        return 1 + self.excess * exp(-self.R * abs(v) / self.stribeck)

    def balance(self, torque: float) -> float:
        """Normal force in equilibrium under a torque that the pairs share as in slip."""
        return self.force - self.C * abs(torque) / self.R * self.z2 * self.f2 / (self.z1 * self.f1 + self.z2 * self.f2)

    def begin(self, load: float, speed: float) -> float:
        """Set the state that runs under a load; return the largest natural frequency of the clutch."""
        self.normal = self.balance(load)
        return 0.1 / self.lag if self.lag else 0.0

    def drift(self, h: float, w2: float) -> None:
        """Move the parts of the clutch by a step; a direct clutch has none."""

    def slip(self, w1: float, w2: float) -> float:
        return w1 - w2

    def kick(self, h: float, v: float, w1: float, w2: float) -> tuple[float, float, float]:
        """Return the speeds of both sides and the torque of the pack after a step, from the speeds without the pack."""
        f1, f2 = self.f1 * self.ratio(v), self.f2 * self.ratio(v)
        most = self.R * self.normal * (self.z1 * f1 + self.z2 * f2) if self.lag else self.torque(f1, f2)
        stop = (w1 - w2) / (h / self.J1 + h / self.J2)
        torque = max(-most, min(most, stop))
        if self.lag:
            end = self.balance(torque)
            self.normal = end + (self.normal - end) * exp(-h / self.lag)
        w1 -= h * torque / self.J1
        return w1, w1 if torque == stop else w2 + h * torque / self.J2, torque


class Indirect(Direct):
    """Pack and balls in series with the hub between them; the balls are seated, or have turned and moved the sleeve."""

    def __init__(self, spec: dict[str, Any], friction: list[float]):
        super().__init__(spec | {"variant": "conventional"}, friction)
        unit, self.Jh, grip = spec["control_unit"], spec["drive"]["hub_inertia"], self.force * self.z * self.set[0]
        self.c1, self.c2 = spec["closing_spring"]["stiffness"], spec["control_spring"]["stiffness"]
        self.key = 2 * self.R * unit["key_friction"] / unit["hub_diameter"]
        self.preload = grip * (self.C - self.key)  # F_п2 - F_п1
        self.slope = (self.c1 + self.c2) / grip if unit.get("pocket") else unit.get("gain_slope", 0.0)
        self.mass, self.turn, self.sleeve, self.crossed = unit.get("sleeve_mass", 0.0), 0.0, 0.0, False

    def torque(self, f1: float, f2: float) -> float:
        return self.z * self.R * f1 * self.force

    def begin(self, load: float, speed: float) -> float:
        net, self.hub = self.C - self.key, speed
        assert load <= self.R * self.preload / net, "it begins at its stop"
        self.normal = self.force + self.preload - net * load / self.R
        return self.R * sqrt((self.c1 + self.c2) / (net * self.C) * (1 / self.Jh + 1 / self.J2))

    def drift(self, h: float, w2: float) -> None:
        before, self.turn = self.turn, self.turn + h * (self.hub - w2)
        if before * self.turn < 0:
            self.sleeve, self.crossed = -self.sleeve, True
        arc = self.R * abs(self.turn)
        self.x = 2 * arc / (self.C + sqrt(self.C**2 + 2 * self.slope * arc))

    def slip(self, w1: float, w2: float) -> float:
        return w1 - self.hub

    def kick(self, h: float, v: float, w1: float, w2: float) -> tuple[float, float, float]:
        gain, rests, seated = self.C + self.slope * self.x, self.turn == 0, self.crossed or self.turn == 0
        out, back, grip, self.crossed = (
            gain - self.key,
            gain + self.key,
            self.z * self.R * self.f1 * self.ratio(v),
            False,
        )
        both, turning, most_normal = 1 / self.Jh + 1 / self.J2, (self.hub - w2) / h, self.force + self.preload
        free = max(self.force - self.c1 * self.x, 0.0)
        spring = self.R * (self.preload + (self.c1 + self.c2) * self.x)
        push = spring - self.R * self.mass * self.sleeve / h

        def normal(balls: float) -> float:
            """Normal force of the sleeve at its stop, within the bounds that friction at the key allows."""
            return sorted((self.normal, *(most_normal - net * abs(balls) / self.R for net in (back, out))))[1]

        def pack(base: float, share: float, rests: bool) -> tuple[float, float, bool]:
            """Return the torques of pack and balls, T_balls = base + share·T_pack, and True if the pack sticks."""
            stop = ((w1 - self.hub) / h + base / self.Jh) / (1 / self.J1 + (1 - share) / self.Jh)
            if abs(stop) <= grip * (normal(base + share * stop) if rests else free):
                return stop, base + share * stop, True
            torque = copysign(grip * (self.normal if rests else free), stop)
            if rests and (reached := normal(base + share * torque)) != self.normal:  # N falls as the torque rises
                for sign in (1.0, -1.0):
                    lean = copysign(grip, stop) * sign * (out if reached < self.normal else back) / self.R
                    torque = (copysign(grip, stop) * most_normal - lean * base) / (1 + lean * share)
                    if sign * (base + share * torque) >= 0:
                        break
            return torque, base + share * torque, False

        torque, balls, stuck = pack(turning / both, 1 / self.Jh / both, rests)
        side = copysign(1.0, self.turn)
        low, high = (-spring / out, spring / out) if seated else sorted((side * push / out, side * push / back))
        if low <= balls <= high and (stuck or not rests or abs(torque) < 1.001 * grip * normal(balls)):
            self.turn, self.sleeve, self.normal = 0.0 if seated else self.turn, 0.0, normal(balls) if rests else free
            self.hub += h * (torque - balls) / self.Jh
            return self.hub if stuck else w1 - h * torque / self.J1, self.hub, torque
        way = copysign(1.0, balls - high)
        side = way if rests else side
        net, self.normal = out if way == side else back, free
        inertia = self.mass * self.R**2 / (gain * net)
        share = 1 / (1 + inertia * both)
        torque, balls, stuck = pack(share * (side * push / net + inertia * turning), inertia * share / self.Jh, False)
        self.hub, w2 = self.hub + h * (torque - balls) / self.Jh, w2 + h * balls / self.J2
        self.sleeve = self.R * side * (self.hub - w2) / gain
        return self.hub if stuck else w1 - h * torque / self.J1, w2, torque


def referee(spec: dict[str, Any], friction: list[float], end: float, steps: float = 1000.0) -> Event:
    """Simulate the event of a drive until ``end``, with ``steps`` per radian of its fastest swing."""
    clutch = (Indirect if spec["variant"] == "indirect" else Direct)(spec, friction)
    drive, event, own = spec["drive"], spec["drive"]["event"], spec["drive"].get("motor")
    k, J3, load, off = drive["shaft_stiffness"], drive.get("tool_inertia", inf), drive["load_torque"], inf
    d, rise = (
        2 * drive.get("damping_ratio", 0.0) * sqrt(k * clutch.J2),
        event.get("stop_time") or event.get("rise_time"),
    )
    speed = drive.get("speed")
    if own:
        Mb, sb, synchronous = own["breakdown_torque"], own["breakdown_slip"], own["synchronous_speed"]
        speed = synchronous * (1 - sb * (Mb / load - sqrt((Mb / load) ** 2 - 1)))
    w1, w2, w3, twist = speed, speed, speed, load / k
    h = 1 / steps / max(clutch.begin(load, speed), sqrt(k * (1 / clutch.J2 + 1 / J3)))
    v = v_before = rate = rate_before = peak = peak_clutch = time = heat = travel = 0.0
    for number in range(round(end / h)):
        t = (number + 0.5) * h
        twist += h / 2 * (w2 - w3)
        clutch.drift(h / 2, w2)
        shaft = k * twist + d * (1.5 * rate - 0.5 * rate_before)
        motor = 0.0 if t > off else drive.get("motor_torque", load)
        if own and motor:
            s = 1 - w1 / synchronous
            motor = 2 * Mb * s * sb / (s * s + sb * sb)
        free = w1 + h * motor / clutch.J1, w2 - h * shaft / clutch.J2
        w1, w2, torque = clutch.kick(h, 1.5 * v - 0.5 * v_before, *free)
        if event["kind"] == "stop":
            w3 = speed * max(1 - (t + h / 2) / rise, 0.0) if rise else 0.0
        else:
            resists = load + (event["torque"] - load) * (min(t / rise, 1.0) if rise else 1.0)
            w3 += h * shaft / J3
            w3 = copysign(max(abs(w3) - h * resists / J3, 0.0), w3)
        v_before, v, rate_before, rate = v, clutch.slip(w1, w2), rate, w2 - w3
        twist += h / 2 * rate
        clutch.drift(h / 2, w2)
        if v or v_before:
            time, heat = time + h, heat + h * abs(torque * (v + v_before)) / 2
            off = min(off, t + drive.get("cut_off", inf))
        peak, peak_clutch, travel = max(peak, abs(shaft)), max(peak_clutch, abs(torque)), max(travel, clutch.x)
    return Event(peak, peak_clutch, time, heat, travel, v != 0)
