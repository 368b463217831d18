"""Explanation of an error or a warning: what its code means, and keys of the spec with values that clear it."""

import math
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import chain
from typing import Any

from ...engines import Clutch, build
from ...errors import AfmcalcError
from ...findings import Finding
from ...messages import did_you_mean, filled, measured, say, spoken
from ...papers.handbook_text import Way, sections
from ...result import Answer, Result, described
from ...spec import Spec
from ...spec.edit import replaced, respecified, value_at
from ...spec.keys import is_whole, keys
from ...units import ENGINEER
from ..check import check, simulating
from ..registry import ANALYSES
from ..solve import quantity_at
from ..sweep import current_value

_ELSEWHERE: dict[str, str | None] = {
    "few-samples": "tolerance", "heavy-tails": "tolerance", "no-clutch": "tolerance", "no-spring": "springs",
    "narrower-below-nominal": "adjust", "margin-role": "overload", "bad-spec": None, "not-attainable": None,
    "no-candidate": None, "sweep-beyond-gain-limit": None, "sweep-not-settled": None, "unexpected-verdict": None,
}  # fmt: skip
"""Code of a finding → analysis that reports it, if not ``check``; None for a finding that is not about a clutch."""
_FACTORS = (1.02, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4, 1.6, 1.8, 2, 2.3, 2.6, 3, 3.5, 4, 5, 6, 8, 10, 14, 20, 30, 50, 100)
"""Values to try, relative to the present value; with simulations only every fifth value, and a fifth of the steps."""
_STEPS, _HALVINGS, _FROM_ZERO = 40, 9, 0.5
"""Steps of a whole number, halvings of an interval, and the value to try for a gain of 0 (as in the papers)."""


class Remedy(Result):
    """A key of the spec, and the value of it with which a finding is gone."""

    about: str | None = described("for", code=True)
    path: str = described("spec key", code=True)
    way: Way = described("which way")
    unit: str = described("unit", is_unit=True)
    value: float = described("value now", unit_in="unit")
    clears: float | None = described("value that clears it", unit_in="unit")
    along: str | None = described("with it, as --set has it", code=True)
    then: str | None = described("what is found then", code=True)


class MendResult(Answer):
    """Meaning of an error or a warning, its sentences for a clutch that has it, and the remedies."""

    code: str = described("error or warning", code=True)
    meaning: str = described("what it means")
    told: list[str] | None = described("what is said of this clutch; null: it is not said of a clutch")
    remedies: list[Remedy] = described("what clears it")

    def words(self, name: str) -> str | None:
        """Empty text, which hides the row, for fields that ``lead`` shows above the tables; None for other fields."""
        return None if name == "remedies" else ""

    @property
    def lead(self) -> str:
        """Text above the tables."""
        said = [say("This clutch does not have it.")] if self.told == [] else self.told or []
        return "\n".join((self.meaning, *said))


def mend(clutch: Clutch, code: str) -> tuple[MendResult, list[Finding]]:
    """Explain an error or a warning and, for a clutch that has it, find the values of keys that clear it.

    Raises AfmcalcError if there is no such code.
    """
    if code not in sections("en"):
        raise AfmcalcError("no error or warning {code!r}{hint}", code=code, hint=did_you_mean(code, sections("en")))
    meaning, spec, quick = sections(spoken())[code].meaning, clutch.spec, True
    own = _graver(before := _findings(spec, code), code)
    if not own and simulating(clutch):
        own, quick = _graver(before := _findings(spec, code, quick=False), code), False
    several = {each.path: each for each in own}
    cures = [remedies(spec, each, before, quick=quick, about=len(several) > 1) for each in several.values()]
    told = [each.message for each in own] if _ELSEWHERE.get(code, "check") else None
    return MendResult(code=code, meaning=meaning, told=told, remedies=[*chain(*cures)]), []


def steps_to_take(spec: Spec, findings: list[Finding]) -> Iterator[str]:
    """Yield a sentence on what to change for each error and warning, errors first.

    The sentence names the first key whose change brings no other finding (keys of requirements last), and the value
    that clears the finding, unless this value would take the simulation of an event.
    """
    quick = {(each.code, each.path): each for each in _findings(spec)}
    graver = {(each.code, each.path): each for each in _graver(findings) if each.code != "requirement-not-judged"}
    for found in sorted(graver.values(), key=lambda each: each.level != "error"):
        ways = sections(spoken())[found.code].ways_of(found)
        cures = remedies(spec, found, [*quick.values()], quick=True) if (found.code, found.path) in quick else ()
        if cure := _first_choice(cures):
            yield f"{_change(cure)}: {found.message}"
        elif ways:
            yield f"{direction(*ways[0])}: {found.message}"
        else:
            yield say("Look into this: {why}", why=found.message)


def direction(path: str, way: Way) -> str:
    """Sentence on the direction in which to change a key so that it clears a finding."""
    return filled(
        "Increase {path}" if way == "+" else "Decrease {path}" if way == "-" else "Change {path}", {"path": path}
    )


def _first_choice(cures: Iterable[Remedy]) -> Remedy | None:
    """Return the first remedy that is no requirement and brings no other finding, else the remedy closest to this."""
    best, rank = None, (True, True, True)
    for cure in cures:
        own = (cure.clears is None, cure.path.startswith("requirements."), cure.then is not None)
        if not own[0] and own < rank:
            best, rank = cure, own
        if not any(rank):
            break
    return best


def _change(cure: Remedy) -> str:
    """Return a sentence on how far a key must be changed."""
    now, value = (measured(each or 0.0, ENGINEER.get(cure.unit, cure.unit), 5) for each in (cure.value, cure.clears))
    change = filled(
        "Increase {path} from {now} to {value}" if cure.way == "+" else "Decrease {path} from {now} to {value}",
        {"path": cure.path, "now": now, "value": value},
    )
    along = ", ".join(each.partition("=")[0] for each in (cure.along or "").split(", "))
    return say("{change}, and {along} to match", change=change, along=along) if along else change


def remedies(
    spec: Spec, found: Finding, before: list[Finding], *, quick: bool, about: bool = False
) -> Iterator[Remedy]:
    """Yield a remedy for each key that the finding's section names and the spec has: the nearest value that clears."""
    known = {each.code for each in _graver(before)}

    def clears(path: str, value: float) -> bool | None:
        """True if a value clears the finding and brings no worse one; None if no clutch can be built with it."""
        try:
            left = _findings(respecified(spec, changes(spec, path, value)), found.code, quick=quick)
        except (AfmcalcError, ArithmeticError):
            return None
        same = [each for each in _graver(left) if each.path == found.path]
        worse = {each.code for each in same if each.level == "error" or each.code == "requirement-not-judged"} - known
        return not worse and found.code not in {each.code for each in same}

    for path, way in sections(spoken())[found.code].ways_of(found):
        if path not in keys():
            continue
        now = current_value(spec, path)
        if now is None and (now := build(spec).get(quantity_at(path))) is None:
            continue
        now = float(now)
        value = _nearest(now, way, partial(clears, path), whole=is_whole(path), quick=quick)
        along = {} if value is None else changes(spec, path, value)
        left = _findings(respecified(spec, along), found.code, quick=quick) if along else []
        then = dict.fromkeys(each.code for each in _graver(left) if each.code not in known)
        yield Remedy(
            about=found.path if about else None, path=path, way=way if value is None else "+" if value > now else "-",
            unit=keys()[path].unit or "1", value=now, clears=value, then=", ".join(then) or None,
            along=", ".join(f"{key}={along[key] or ''}" for key in along if not path.startswith(key)) or None,
        )  # fmt: skip


def changes(spec: Spec, path: str, value: float) -> dict[str, Any]:
    """Return a key with its value, and the changes that follow: replaced keys are removed, a part sets a stiffness."""
    given: dict[str, Any] = {path: round(value) if is_whole(path) else value} | dict.fromkeys(replaced(spec, [path]))
    spring, kind, name = (*path.split("."), "", "")[:3]
    part, stiffness = value_at(spec, f"{spring}.{kind}"), f"{spring}.stiffness"
    if kind == "coil" and value_at(spec, stiffness) is not None:
        part = part.model_copy(update={name: given.pop(path)})
        given |= {f"{spring}.coil": part.model_dump(), stiffness: part.rate}
    elif kind == "disc" and spring == "closing_spring":
        given[stiffness] = None
    return given


def _findings(spec: Spec, code: str = "", *, quick: bool = True) -> list[Finding]:
    """Return the findings of the analysis that reports a code; if ``quick``, without simulations, samples and life.

    The analysis of life would take half of the time, and adds only notes to the checks of its stresses.
    """
    clutch, name = build(spec), _ELSEWHERE.get(code, "check")
    if name == "check":
        return check(clutch, without=simulating(clutch) | {"life"} if quick else ())[1]
    return ANALYSES[name].function(clutch)[1] if name and ANALYSES[name].applies(clutch) else []


def _graver(findings: Iterable[Finding], code: str = "") -> list[Finding]:
    return [each for each in findings if each.level != "info" and code in ("", each.code)]


def _nearest(now: float, way: Way, clears: Callable[[float], bool | None], *, whole: bool, quick: bool) -> float | None:
    """Return the value nearest to ``now`` that clears a finding, to three digits; None if no value clears it."""
    every = 1 if quick else 5
    for up in (True, False) if way == "±" else (way == "+",):
        held = now
        if whole:
            values = [now + (step if up else -step) for step in range(1, _STEPS // every + 1)]
        else:
            values = (
                [now * each if up else now / each for each in _FACTORS[every - 1 :: every]] if now else [_FROM_ZERO]
            )
        for value in values:
            if good := clears(value):
                return value if whole or not held else _drawn_in(held, value, clears, _HALVINGS // every)
            if good is None:
                break
            held = value
    return None


def _drawn_in(held: float, clearing: float, clears: Callable[[float], bool | None], halvings: int) -> float:
    """Return by bisection the value nearest to ``held`` that clears a finding; ``held`` itself does not clear it."""
    up = clearing > held
    for _ in range(halvings):
        middle = math.sqrt(held * clearing)
        held, clearing = (held, middle) if clears(middle) else (middle, clearing)
    step = 10.0 ** (math.floor(math.log10(clearing)) - 2)
    rounded = float(f"{(math.ceil if up else math.floor)(clearing / step) * step:.3g}")
    return rounded if clears(rounded) else clearing
