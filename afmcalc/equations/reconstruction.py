"""Formulas of the papers that their text has lost, put together again from what is left of them."""

from .calls import equation
from .terms import *


@equation
def friction_bound(pairs: Pairs, margin: Margin, reduced_gain: ReducedGainOfPairs) -> Friction:
    """Friction below which S22 (10) is positive, 1/[zC (z − 1)(β_н − 1)] + z/(zC).

    Source: S22 (11), a reconstruction at zC = 5: from the signs left of (10), 1 + z (z − 1)(β_н − 1)(1 − C f), and of
        (11), from the minimum at z = 3 that the text states for β_н = 1.25, and from the value 1.0 there.
    Validity: z ≥ 2, as the paper states it. As a torque difference (10) cannot be right, for it is a pure number (M15).
    """
    return 1 / (reduced_gain * (pairs - 1) * (margin - 1)) + pairs / reduced_gain
