"""What a picture of the springs shows: force over deflection, and where on it the clutch works."""

import numpy as np

from ...engines.characteristic import Characteristic, characteristic
from ...engines.protocol import Clutch
from ...engines.wish import SpringName, Wish
from ...errors import CalculationError
from ...messages import say
from ...result import Result, Sentence, quantity
from .candidates import label_of
from .options import part_of
from .springs import ranked

POINTS = 121


class SpringCurve(Result):
    """One spring."""

    spring: SpringName = quantity("", None, "spring")
    part: Sentence = quantity("", None, "part")
    deflection: list[float] = quantity("m", "s", "deflection")
    force: list[float] = quantity("N", "F", "force")
    tangent: list[float] = quantity("N", "c s", "straight spring of the stiffness as set")
    set_deflection: float = quantity("m", "s", "deflection as set")
    set_force: float = quantity("N", "F", "force as set")
    service: tuple[float, float] = quantity("m", "s", "deflections in service")
    usable: tuple[float, float] = quantity("m", "s", "deflections it may be used between")


class SpringsCurve(Result):
    """The springs of a clutch."""

    name: str | None = quantity("", None, "name of the clutch", optional=True)
    springs: list[SpringCurve] = quantity("", None, "springs")


def springs_curve(clutch: Clutch) -> SpringsCurve:
    """Calculate the characteristic of the parts that a spec names, else of the best that is found.

    Raises:
        CalculationError: there is no part.
    """
    found = [_curve(clutch, wish) for wish in clutch.wishes()]
    return SpringsCurve(name=clutch.spec.name, springs=found)


def _curve(clutch: Clutch, wish: Wish) -> SpringCurve:
    named = clutch.spec.spring_parts.get(wish.name)
    if named is None:
        best = ranked(wish)
        if not best:
            raise CalculationError(say("plot springs: there is no part for the {name} spring", name=wish.name))
        part, own = best[0].part, characteristic(part_of(best[0]))
    else:
        part, own = label_of(named), characteristic(named)
    return _drawn(wish, part, own)


def _drawn(wish: Wish, part: str, own: Characteristic) -> SpringCurve:
    deflections = np.linspace(0.0, own.end, POINTS)
    at = float(own.deflection(wish.force))
    slope = float(own.stiffness(at))
    return SpringCurve(
        spring=wish.name,
        part=part,
        deflection=deflections.tolist(),
        force=np.asarray(own.force(deflections)).tolist(),
        tangent=(wish.force + slope * (deflections - at)).tolist(),
        set_deflection=at,
        set_force=float(own.force(at)),
        service=(at - wish.relaxes, at + wish.compresses),
        usable=own.range,
    )
