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
    """Pack between motor side and driven half; with a lag its normal force is late."""

    def __init__(self, spec: dict[str, Any], friction: list[float]):
        group, law, unit = spec["friction_group"], spec["friction"], spec.get("control_unit", {})
        self.z, self.R, self.C = group["pairs"], group["mean_radius"], unit.get("gain", 0.0)
        bypass = {"conventional": self.z, "differentiated": group.get("driving_pairs", 1)}.get(spec["variant"], 0)
        self.f, self.bypass, self.driven = (friction[0], friction[-1]), bypass, self.z - bypass
        self.excess, self.stribeck = law.get("static_ratio", 1.0) - 1, law.get("stribeck_speed", 1.0)
        self.lag, self.x, self.force, own = unit.get("release_lag", 0.0), 0.0, 1.0, spec["adjustment"]
        self.J1, self.J2 = spec["drive"]["motor_inertia"], spec["drive"]["driven_inertia"]
        name, margin = ("mean", own["margin"]) if own.get("method") == "mean-friction" else ("min", 1.0)
        self.set = [law.get(pairs, law)[name] for pairs in ("driving", "driven")]
        self.force = margin * own["nominal_torque"] / self.torque(*self.set)

    def torque(self, f1: float, f2: float) -> float:
        return self.force * self.R * (self.bypass * f1 + self.driven * f2) / (1 + self.C * self.driven * f2)

    def ratio(self, v: float) -> float:
        """Friction at a slip over that of fast slip."""
        return 1 + self.excess * exp(-self.R * abs(v) / self.stribeck)

    def balance(self, torque: float) -> float:
        """Normal force that a torque leaves in the end, shared by the pairs as they carry it in slip."""
        carried = self.driven * self.f[1] / (self.bypass * self.f[0] + self.driven * self.f[1])
        return self.force - self.C * carried * abs(torque) / self.R

    def begin(self, load: float, speed: float) -> float:
        """Run under a load; return its own largest frequency."""
        self.normal = self.balance(load)
        return 0.1 / self.lag if self.lag else 0.0

    def drift(self, h: float, w2: float) -> None:
        """Turn what turns."""

    def slip(self, w1: float, w2: float) -> float:
        return w1 - w2

    def kick(self, h: float, v: float, w1: float, w2: float, a1: float, shaft: float) -> tuple[float, float, float]:
        """Speeds of both sides after a step, torque of the pack; ``a1`` is what the motor alone would do."""
        f1, f2 = (each * self.ratio(v) for each in self.f)
        most = self.R * self.normal * (self.bypass * f1 + self.driven * f2) if self.lag else self.torque(f1, f2)
        w1, w2 = w1 + h * a1, w2 - h * shaft / self.J2
        stop = (w1 - w2) / (h / self.J1 + h / self.J2)
        torque = max(-most, min(most, stop))
        if self.lag:
            end = self.balance(torque)
            self.normal = end + (self.normal - end) * exp(-h / self.lag)
        w1 -= h * torque / self.J1
        return w1, w1 if torque == stop else w2 + h * torque / self.J2, torque


class Indirect(Direct):
    """Pack and balls in series, the hub between them: balls are seated, or have turned and moved the sleeve."""

    def __init__(self, spec: dict[str, Any], friction: list[float]):
        super().__init__(spec | {"variant": "conventional"}, friction)
        unit, self.c1, self.c2 = (
            spec["control_unit"],
            *(spec[each]["stiffness"] for each in ("closing_spring", "control_spring")),
        )
        self.key, grip = 2 * self.R * unit["key_friction"] / unit["hub_diameter"], self.force * self.z * self.set[0]
        self.preload = grip * (self.C - self.key)  # F_п2 - F_п1
        self.slope = (self.c1 + self.c2) / grip if unit.get("pocket") else unit.get("gain_slope", 0.0)
        self.mass, self.Jh = unit.get("sleeve_mass", 0.0), spec["drive"]["hub_inertia"]

    def torque(self, f1: float, f2: float) -> float:
        return self.z * self.R * f1 * self.force

    def begin(self, load: float, speed: float) -> float:
        net = self.C - self.key
        assert load <= self.R * self.preload / net, "it begins at its stop"
        self.hub, self.turn, self.sleeve, self.crossed = speed, 0.0, 0.0, False
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

    def kick(self, h: float, v: float, w1: float, w2: float, a1: float, shaft: float) -> tuple[float, float, float]:
        gain = self.C + self.slope * self.x
        out, back, rests = gain - self.key, gain + self.key, self.turn == 0
        seated, self.crossed = rests or self.crossed, False
        w1, w2, grip = w1 + h * a1, w2 - h * shaft / self.J2, self.z * self.R * self.f[0] * self.ratio(v)
        both, turning = 1 / self.Jh + 1 / self.J2, self.hub - w2
        free = max(self.force - self.c1 * self.x, 0.0)
        spring = self.R * (self.preload + (self.c1 + self.c2) * self.x)
        push = spring - self.R * self.mass * self.sleeve / h

        def normal(balls: float) -> float:
            ends = (self.force + self.preload - net * abs(balls) / self.R for net in (back, out))
            return sorted((self.normal, *ends))[1]

        def pack(base: float, share: float, at_stop: bool) -> tuple[float, float, bool]:
            """Torques of pack and balls, the latter base + share times the former; whether the pack sticks."""
            stop = ((w1 - self.hub) / h + base / self.Jh) / (1 / self.J1 + (1 - share) / self.Jh)
            if abs(stop) <= grip * (normal(base + share * stop) if at_stop else free):
                return stop, base + share * stop, True
            most = grip * (self.normal if at_stop else free)
            reached = normal(base + share * copysign(most, stop)) if at_stop else self.normal
            if reached != self.normal:  # what the pack bears falls as its torque rises
                for sign in (1.0, -1.0):
                    lean = sign * (out if reached < self.normal else back) / self.R
                    most = (
                        grip
                        * (self.force + self.preload - lean * base)
                        / (1 + grip * lean * share * copysign(1.0, stop))
                    )
                    if sign * (base + share * copysign(most, stop)) >= 0:
                        break
            torque = copysign(most, stop)
            return torque, base + share * torque, False

        torque, balls, stuck = pack(turning / h / both, 1 / self.Jh / both, rests)
        side = copysign(1.0, self.turn)
        ends = (-spring / out, spring / out) if seated else sorted((side * push / out, side * push / back))
        held = ends[0] <= balls <= ends[1] and (stuck or not rests or abs(torque) < 1.001 * grip * normal(balls))
        if held:
            self.sleeve = 0.0
            self.turn = 0.0 if seated else self.turn
        else:
            way = 1.0 if balls > ends[1] else -1.0
            side = way if self.turn == 0 else side
            net = out if way == side else back
            inertia = self.mass * self.R**2 / (gain * net)
            base, share = side * push / net, 1 / (1 + inertia * both)
            base = base * share + inertia * share * turning / h
            torque, balls, stuck = pack(base, inertia * share / self.Jh, False)
        self.hub += h * (torque - balls) / self.Jh
        w1, w2 = w1 - h * torque / self.J1, w2 + h * balls / self.J2
        self.normal = normal(balls) if held and rests else free
        if held:
            w2 = self.hub
        else:
            self.sleeve = self.R * side * (self.hub - w2) / gain
        return self.hub if stuck else w1, w2, torque


def referee(spec: dict[str, Any], friction: list[float], end: float, steps: float = 1000.0) -> Event:
    """The event of a drive until an end, ``steps`` for each radian of its fastest swing."""
    clutch = (Indirect if spec["variant"] == "indirect" else Direct)(spec, friction)
    drive, event, own = spec["drive"], spec["drive"]["event"], spec["drive"].get("motor")
    k, J3, load = drive["shaft_stiffness"], drive.get("tool_inertia", inf), drive["load_torque"]
    d = 2 * drive.get("damping_ratio", 0.0) * sqrt(k * clutch.J2)
    if own:
        ratio, sb = own["breakdown_torque"] / load, own["breakdown_slip"]
        speed = own["synchronous_speed"] * (1 - sb * (ratio - sqrt(ratio**2 - 1)))
    else:
        speed = drive["speed"]
    w1 = w2 = w3 = speed
    twist, own_frequency = load / k, clutch.begin(load, speed)
    h = 1 / steps / max(sqrt(k * (1 / clutch.J2 + 1 / J3)), own_frequency)
    v = v_before = rate = rate_before = 0.0
    peak, peak_clutch, time, heat, travel, off, slips = load, 0.0, 0.0, 0.0, 0.0, inf, False
    for number in range(round(end / h)):
        t = (number + 0.5) * h
        twist += h / 2 * (w2 - w3)
        clutch.drift(h / 2, w2)
        shaft = k * twist + d * (1.5 * rate - 0.5 * rate_before)
        motor = 0.0 if t > off else drive.get("motor_torque", load)
        if own and motor:
            s = 1 - w1 / own["synchronous_speed"]
            motor = 2 * own["breakdown_torque"] * s * sb / (s * s + sb * sb)
        w1, w2, torque = clutch.kick(h, 1.5 * v - 0.5 * v_before, w1, w2, motor / clutch.J1, shaft)
        if event["kind"] == "stop":
            w3 = speed * max(1 - (t + h / 2) / event["stop_time"], 0.0) if event["stop_time"] else 0.0
        else:
            rise = min(t / event["rise_time"], 1.0) if event["rise_time"] else 1.0
            w3 += h * shaft / J3
            w3 = copysign(max(abs(w3) - h * (load + (event["torque"] - load) * rise) / J3, 0.0), w3)
        v_before, v, rate_before, rate = v, clutch.slip(w1, w2), rate, w2 - w3
        twist += h / 2 * rate
        clutch.drift(h / 2, w2)
        slips = v != 0 or v_before != 0
        if slips:
            time, heat, off = (
                time + h,
                heat + h * abs(torque * (v + v_before)) / 2,
                min(off, t + drive.get("cut_off", inf)),
            )
        peak, peak_clutch, travel = max(peak, abs(shaft)), max(peak_clutch, abs(torque)), max(travel, clutch.x)
    return Event(peak, peak_clutch, time, heat, travel, slips)
