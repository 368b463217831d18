"""From a wanted quantity back to one parameter: closed where the law can be inverted, else a bracketed root."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeGuard

import numpy as np

from ...engines import Clutch, build
from ...equations.arrays import Floats, Values
from ...errors import AfmcalcError, CalculationError
from ...findings import Finding, finding
from ...messages import did_you_mean, joined, measured, plain, say, term
from ...progress import tell, unwatched
from ...result import Answer, described, quantity
from ...spec import Spec
from ...spec.edit import replaced, respecified, value_at, with_keys
from ...spec.keys import ALIASES, is_whole, keys, path_of
from ...spec.models import COLDEST
from ...spec.quantity import asked_unit, parse_quantity
from ...spec.rules import variants_of
from ...units import ENGINEER
from ..answers import Answers
from ..clutch_findings import clutch_findings
from ..registry import ANALYSES
from .search import SAME, Curve, Domain, closed_inverse, domain_of, explore, looked, places, roots

if TYPE_CHECKING:
    from ..requirements import Judged

PARAMETERS = {"C": "1", "F": "N", "z": "1", "z1": "1", "R": "m", "c1": "N/m", "c2": "N/m", "gain_slope": "1/m"}
"""Keys that can be solved for, by symbol, and their SI units."""


class Target(NamedTuple):
    """One quantity of a clutch that can be wanted, as a function of it."""

    unit: str
    description: str
    value: Callable[[Clutch], Values]
    better: Literal["low", "high"]
    """Which side of the wanted value still meets it, where only whole numbers can be chosen."""
    symbols: tuple[str, ...]
    """What else it is called: symbols, and the path of the key that sets it."""
    analysis: str = ""
    """The analysis that is asked for one clutch at a time; none where the engines give many at once."""


def _engine(name: str, unit: str, about: str, better: Literal["low", "high"], *symbols: str) -> tuple[str, Target]:
    """Return a quantity of the engines, called as theirs, as a target."""

    def value(clutch: Clutch) -> Values:
        if not clutch.spec.kind.travels and name in ("control_force", "travel_max"):
            raise AfmcalcError("{name} is only of an indirect clutch: a direct one has no sleeve", name=name)
        lasting = clutch.spec.kind.travels or name != "accuracy_factor_hysteresis"
        return getattr(clutch, name if lasting else "accuracy_factor")

    return name, Target(unit, about, value, better, symbols)


TARGETS: dict[str, Target] = dict(
    (
        _engine("accuracy_factor", "1", "accuracy factor", "low", "K_т"),
        _engine("accuracy_factor_peak", "1", "accuracy factor by breakaway peaks", "low", "K_т,p"),
        _engine("accuracy_factor_hysteresis", "1", "accuracy factor under a load that lasts", "low", "K_т,h"),
        _engine("nominal_torque", "N*m", "nominal torque of the clutch", "high", "T_н", "adjustment.nominal_torque"),
        _engine("torque_min", "N*m", "smallest torque", "high", "T_min"),
        _engine("torque_max", "N*m", "largest torque", "low", "T_max"),
        _engine("scatter", "N*m", "torque scatter band", "low", "ΔT"),
        _engine("reduced_gain", "1", "reduced gain", "low", "zC", "z_2 C", "z_2C"),
        _engine("closing_force", "N", "closing-spring force", "low", "F_п", "F", "closing_spring.force"),
        _engine("control_force", "N", "control-spring force at the stop", "low", "F_п2", "F2", "control_spring.force"),
        _engine("travel_max", "m", "largest travel of the sleeve", "low", "x_max"),
    )
)
"""Name, as in the JSON of the other commands → what it is, of what the engines give for many clutches at once."""


@cache
def targets() -> dict[str, Target]:
    """Every target by name: those of the engines, and what else ``check`` judges."""
    from ..requirements import JUDGED

    return TARGETS | {name: _judged(name, judged) for name, judged in JUDGED.items() if name not in TARGETS}


def target_called(name: str) -> Target:
    """Return the target of that name; what ``check`` judges is imported only when asked for."""
    return TARGETS.get(name) or targets()[name]


def _judged(name: str, judged: "Judged") -> Target:
    """Take what ``check`` judges by a requirement as a target; what may be more, or has no limit, is infinite."""

    def value(clutch: Clutch) -> Values:
        result = Answers(clutch).ask(judged.analysis)[0] if ANALYSES[judged.analysis].applies(clutch) else None
        outcome = None if result is None else judged.outcome(clutch, result)
        if outcome is None:
            needs = term(judged.needs or f"`{judged.analysis}`")
            raise AfmcalcError("{name} cannot be solved for: it needs {needs}", name=name, needs=needs)
        return math.inf if judged.open(result) else outcome

    key = keys()[f"requirements.{name}"]
    about, symbols = key.description.partition(",")[0], (key.symbol or name,)
    return Target(key.unit or "1", about, value, "high" if judged.least else "low", symbols, judged.analysis)


def _target_of(text: str) -> str | None:
    """Return the target that ``NAME`` or ``NAME=VALUE`` names, by name or symbol; None when it names none."""
    wanted = plain(text.partition("=")[0].strip())
    known = (named for targets_of in (TARGETS.copy, targets) for named in targets_of().items())
    return next((name for name, target in known if wanted in map(plain, (name, *target.symbols))), None)


def in_order(target: str, spec: str | None) -> tuple[str, str | None]:
    """Return target and spec, whichever was given first.

    >>> in_order("clutch.toml", "K_т=2")
    ('K_т=2', 'clutch.toml')
    """

    def is_target(text: str) -> tuple[bool, bool]:
        return "=" in text and _target_of(text) is not None, "=" in text

    return (spec, target) if spec is not None and is_target(spec) > is_target(target) else (target, spec)


def parse_target(text: str) -> tuple[str, float, list[Finding]]:
    """Read ``NAME=VALUE``, the value in SI or with a unit; a number that is rarely meant in SI is asked after.

    Raises:
        AfmcalcError: no such target, or no such value.
    """
    given, separator, value = (part.strip() for part in text.partition("="))
    name = _target_of(given)
    if name is None:
        known = [*targets(), *(symbol for target in targets().values() for symbol in target.symbols)]
        raise AfmcalcError(
            "{text!r:.80} is no target{hint}; write NAME=VALUE, NAME one of {known}",
            text=text,
            hint=did_you_mean(given, known),
            known=", ".join(f"{name} ({target.symbols[0]})" for name, target in targets().items()),
        )
    if not separator or not value:
        raise AfmcalcError("{text:.80}: write {name}=VALUE", text=text, name=given)
    number: float | str = value
    with suppress(ValueError):
        number = float(value)
    try:
        wanted = parse_quantity(number, target_called(name).unit)
        question = asked_unit(number, target_called(name).unit, name)
    except ValueError as error:
        raise AfmcalcError("{text:.80}: {why}", text=text, why=error) from None
    if target_called(name).unit == "K abs" and wanted < COLDEST and isinstance(number, float):
        why = say(
            'a number without a unit is in K, and must be at least {bound:g}: "{number} degC"?',
            bound=COLDEST, number=value,
        )  # fmt: skip
        raise AfmcalcError("{text:.80}: {why}", text=text, why=why)
    if not wanted > 0:
        raise AfmcalcError("{text:.80}: must be greater than 0", text=text)
    return name, wanted, [question] if question else []


class NotAttainableError(CalculationError):
    """No value gives what is wanted; ``best`` is the nearest there is, ``at`` where, None where only approached."""

    def __init__(self, message: str, best: float, at: float | None) -> None:
        """Say it, and keep the numbers."""
        super().__init__(message)
        self.best, self.at = best, at


class SolveResult(Answer):
    """The value of one parameter that gives what is wanted, and the clutch it gives."""

    parameter: str = described("parameter solved for")
    path: str = described("spec path")
    unit: str = described("SI unit of the parameter", is_unit=True)
    value: float = described("value found", unit_in="unit")
    exact_value: float | None = described("value before rounding to a whole number", optional=True, unit_in="unit")
    target: str = described("wanted quantity")
    target_unit: str = described("SI unit of the target", is_unit=True)
    wanted: float = described("wanted value", unit_in="shown_unit")
    reached: float = described("value reached", unit_in="shown_unit")
    method: Literal["closed-form", "bracketed-root"] = described("way of solution")
    gain: float = quantity("1", "C", "feedback gain")
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    torque_max: float = quantity("N*m", "T_max", "largest torque")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")

    @property
    def shown_unit(self) -> str:
        """Unit of the target: a temperature is shown by another scale than a difference of two."""
        return target_called(self.target).unit


_NOW = {"C": "gain", "F": "closing_force", "z1": "bypass_pairs", "R": "mean_radius"}
"""Parameter → what it is called of a clutch, where a spec may leave it out."""
_OF_THE_CLUTCH = ("gain", "closing_force", "nominal_torque", "torque_max", "scatter", "accuracy_factor")
"""Fields of the result that are quantities of the clutch with the value in it."""


def solve(
    clutch: Clutch, name: str, target: str, wanted: float, *, beyond_limit: bool = False
) -> tuple[SolveResult, Clutch, list[Finding]]:
    """Find the value of a parameter that gives a wanted quantity, the smallest, and that clutch; others in a finding.

    The parameter is one of ``PARAMETERS``, or the name or path of its key; the target a name of ``targets()``;
    ``beyond_limit`` goes past the gain limit of the variant.

    Raises:
        NotAttainableError: the message gives the best and where it is reached.
        CalculationError: the target does not depend on the parameter.
        AfmcalcError: the parameter is none of the variant's.
    """
    name = _symbol(name, clutch.spec)
    sought, whole, path = target_called(target), is_whole(ALIASES[name]), ALIASES[name]
    problem = _Problem(clutch, name, target, sought, wanted, domain_of(clutch, name, beyond_limit=beyond_limit))
    now = float(sought.value(clutch))  # says what it needs; one event that takes too long is refused
    if sought.analysis:
        curve, solutions = looked(problem.values, wanted, problem.at)
    else:
        curve = explore(problem.values, wanted, problem.domain)
        solutions = roots(problem.values, wanted, curve)
    if len(curve.at) > 1 and np.isfinite(curve.value[0]) and np.allclose(curve.value, curve.value[0], 1e-12, 0):
        raise CalculationError(
            "{target} does not depend on {name} here: it is {level} for every value",
            target=target,
            name=name,
            level=problem.shown(float(curve.value[0])),
        )
    exact = problem.closed(curve, now)
    if exact is not None:
        solutions = sorted([exact, *(root for root in solutions if abs(root - exact) > 1e-6 * abs(exact))])
    chosen = problem.whole(solutions) if whole else solutions
    if not chosen:
        raise _not_attainable(problem, curve)
    beyond = curve.value[curve.at > chosen[0]][:2]
    # as far as numbers tell, the target keeps the wanted value from there on; a closed inverse tells better
    flat = len(beyond) == 2 and np.allclose(beyond, wanted, 1e-13, 0)
    if flat and not whole and chosen[0] != exact:
        raise CalculationError(
            "{target} = {wanted} is given by a whole range of {name}, not by one value: choose one, or solve for "
            "another parameter",
            target=target,
            wanted=problem.shown(wanted),
            name=name,
        )
    changed = {path: chosen[0]}
    solved = build(respecified(clutch.spec, changed))
    result = SolveResult(
        parameter=name,
        path=path,
        unit=PARAMETERS[name],
        value=chosen[0],
        exact_value=(solutions[0] if solutions else None) if whole else None,
        target=target,
        target_unit=sought.unit.removesuffix(" abs"),
        wanted=wanted,
        reached=float(sought.value(solved)),
        method="closed-form" if solutions and solutions[0] == exact else "bracketed-root",
        **{name: getattr(solved, name) for name in _OF_THE_CLUTCH},
    )
    remarks = [finding("solve-replaces", "info", path=other, by=path) for other in replaced(clutch.spec, changed)]
    if others := chosen[1:]:
        listed = joined(say("{name} = {value}", name=name, value=measured(value, PARAMETERS[name])) for value in others)
        given = problem.shown(wanted)
        remarks.append(
            finding(
                "solve-another-value", "info", value=others[0], path=path, target=target, wanted=given, others=listed
            )
        )
    if sought.analysis:
        remarks.append(finding("solve-looked", "info", path=path, target=target, name=name, **problem.seen))
    return result, solved, [*clutch_findings(solved.spec, solved.quantities), *remarks]


@dataclass(frozen=True)
class _Problem:
    """What is to be solved: one parameter of a clutch, within its domain, for a wanted value of a target."""

    clutch: Clutch
    name: str
    target: str
    sought: Target
    wanted: float
    domain: Domain
    known: dict[float, float] = field(default_factory=dict)
    """Value of the parameter → the target, where each takes its time; NaN where it has none."""

    @property
    def path(self) -> str:
        """Spec path of the parameter."""
        return ALIASES[self.name]

    @cached_property
    def at(self) -> Floats:
        """Values of the parameter to look at, where each takes its time."""
        from ..requirements import simulates

        name, clutch, analysis = self.name, self.clutch, self.sought.analysis
        now = getattr(clutch, _NOW.get(name, ""), None)
        if analysis == "life" and clutch.spec.drive.dynamic_factor is None:
            analysis = "simulate"
        whole, slow = is_whole(self.path), simulates(analysis, clutch)
        now = value_at(clutch.spec, self.path) if now is None else now
        at = places(self.domain, now, 16 if slow else 100, 10 if slow or whole else 100, whole=whole)
        if not len(at):
            raise CalculationError(
                "{path}: {target} is looked for around the value of the spec, which has none above 0",
                path=self.path,
                target=self.target,
            )
        return at

    @property
    def seen(self) -> dict[str, Any]:
        """How many of those values there are, and their ends."""
        low, high = (measured(end, PARAMETERS[self.name], 4) for end in (self.at[0], self.at[-1]))
        return {"count": len(self.at), "low": low, "high": high}

    def values(self, at: Floats) -> Floats:
        """The target at values of the parameter."""
        if self.sought.analysis:
            return np.array([self._value(one) for one in at.tolist()])
        with np.errstate(all="ignore"):
            value = self.sought.value(build(with_keys(self.clutch.spec, {self.path: at})))
        return np.broadcast_to(np.asarray(value, float), at.shape)

    def _value(self, at: float) -> float:
        if at not in self.known:
            tell(say("solving"), len(self.known), len(self.at) + 12)
            # validated as a file would be; between whole numbers there are no files
            changed = with_keys if is_whole(self.path) else respecified
            with suppress(AfmcalcError), unwatched():
                self.known[at] = float(self.sought.value(build(changed(self.clutch.spec, {self.path: at}))))
        return self.known.setdefault(at, math.nan)

    def shown(self, value: float) -> str:
        """A value of the target with its unit."""
        unit = self.sought.unit
        return measured(value, ENGINEER[unit] if unit == "K abs" else unit)

    def closed(self, curve: Curve, now: float) -> float | None:
        """Value that the closed inverse gives; None where there is none, or it lies off the curve."""
        # a number of NumPy: what has no answer is NaN, not an exception of a kind of its own for each equation
        with np.errstate(all="ignore"):
            inverse = closed_inverse(self.clutch, self.name, self.target, now, np.float64(self.wanted))
        if inverse is None or not len(curve.at):
            return None
        exact = float(np.clip(inverse, curve.at[0], curve.at[-1]))
        if not abs(exact - float(inverse)) <= SAME * abs(exact):
            return None
        return exact if abs(self.values(np.array([exact]))[0] - self.wanted) <= SAME * self.wanted else None

    def whole(self, solutions: list[float]) -> list[float]:
        """Whole numbers that meet the wanted value: next to each solution, else the end of the domain that does."""
        low, high = self.domain.low, self.domain.high
        numbers = []
        for root in solutions:
            near = self._meeting(np.clip([math.floor(root * (1 + 1e-12)), math.ceil(root * (1 - 1e-12))], low, high))
            numbers += near[np.argsort(np.abs(near - root))].tolist()[:1]
        if numbers:
            return list(dict.fromkeys(numbers))
        ends = np.array([end for end in (low, high) if math.isfinite(end)])
        nearer = ends[np.argsort(np.abs(self.values(ends) - self.wanted), kind="stable")]
        return self._meeting(nearer).tolist()[:1]

    def _meeting(self, at: Floats) -> Floats:
        """Those values of the parameter at which the target is as wanted or better."""
        value = self.values(at)
        low = self.sought.better == "low"
        meets = value <= self.wanted * (1 + SAME) if low else value >= self.wanted * (1 - SAME)
        return at[meets & np.isfinite(value)]


def _symbol(name: str, spec: Spec) -> str:
    """Symbol of a parameter, however it is called; refuse one that the variant does not have."""
    path, symbols = path_of(name), {ALIASES[symbol]: symbol for symbol in PARAMETERS}
    if path not in symbols:
        known = [*PARAMETERS, *symbols, *(path.rpartition(".")[2] for path in symbols)]
        raise AfmcalcError(
            "--for {name:.80}: cannot be solved for{hint}; one of {names}",
            name=name,
            hint="" if path else did_you_mean(name, known),
            names=", ".join(f"{symbol} ({path})" for path, symbol in symbols.items()),
        )
    if (only := variants_of(path)) and spec.variant not in only:
        raise AfmcalcError(
            "--for {name}: {path} is only for {only}, not {variant!r}",
            name=symbols[path],
            path=path,
            only=", ".join(only),
            variant=spec.variant,
        )
    return symbols[path]


def _not_attainable(problem: _Problem, curve: Curve) -> CalculationError:
    """Say what is nearest to the wanted value, and where."""
    name, wanted, domain = problem.name, problem.wanted, problem.domain

    def refusal(nearest: str) -> str:
        return say(
            "{target} = {wanted} is not attainable by {name}: {nearest}",
            target=problem.target,
            wanted=problem.shown(wanted),
            name=name,
            nearest=nearest,
        )

    finite = np.isfinite(curve.value)
    at, value, endless = curve.at[finite], curve.value[finite], curve.at[np.isinf(curve.value)]
    if is_whole(problem.path) and len(at):
        at = np.unique(np.clip(np.concatenate([np.floor(at), np.ceil(at)]), domain.low, domain.high))
        value = problem.values(at)
    if not len(at):
        none = say("no value of {name} gives a clutch", name=name)
        return CalculationError(
            refusal(say("it has no end at any {name} looked at", name=name) if len(endless) else none)
        )
    # all on one side of the wanted value, unless the quantity jumps over it
    gap = np.abs(value - wanted)
    tied = np.flatnonzero(gap <= gap.min() + 1e-13 * abs(value[np.argmin(gap)]))
    best = tied[-1] if at[tied[-1]] == domain.high else tied[0]
    nearest, place = float(value[best]), float(at[best])

    def nearer(limit: float | None) -> TypeGuard[float]:
        return limit is not None and abs(nearest - wanted) - abs(limit - wanted) > 1e-12 * abs(limit)

    if nearer(limit := curve.limit_low):
        where = say("the best is {best}, approached as {name} goes to 0", best=problem.shown(limit), name=name)
        return NotAttainableError(refusal(where), limit, None)
    if nearer(limit := curve.limit_high):
        where = say("the best is {best}, approached as {name} grows without end", best=problem.shown(limit), name=name)
        return NotAttainableError(refusal(where), limit, None)
    where = say(
        "the best is {best}, reached at {name} = {place}{why}",
        best=problem.shown(nearest),
        name=name,
        place=measured(place, PARAMETERS[name]),
        why=say(" ({why})", why=domain.why) if place == domain.high and domain.why else "",
    )
    if len(endless):
        nearest_endless = measured(endless[np.argmin(np.abs(endless - place))], PARAMETERS[name])
        where = say("{where}; it has no end at {name} = {place}", where=where, name=name, place=nearest_endless)
    if problem.sought.analysis:
        where = say("{where}, of {count} values from {low} to {high}", where=where, **problem.seen)
    return NotAttainableError(refusal(where), nearest, place)
