"""The closed inverses: each put back into the law it inverts gives what was wanted."""

import sympy as sp

from ..equations import accuracy, direct, indirect, synthesis
from . import Identity, Refutation, Steps
from .symbols import C, F, R, c1, c2, f1, f1max, f1min, f2, f2max, f2min, fmax, fmin, fset, q, z, z1, z2

__all__ = [
    "best_attainable_accuracy",
    "inverses_of_indirect_accuracy",
    "inverses_of_the_accuracy",
    "inverses_of_the_torque",
]

K, T = sp.symbols("K T", positive=True)


def inverses_of_the_accuracy() -> Steps:
    """Gain and pairs for a wanted K_т put back into F11 (14) give it."""
    ends = f1min, f2min, f1max, f2max
    gain = synthesis.gain_for_accuracy_factor(z1, z2, K, *ends)
    yield Identity("K_т(C) = K", accuracy.accuracy_factor(z1, z2, gain, *ends) - K)
    pairs = synthesis.controlled_pairs_for_accuracy_factor(C, K, fmin, fmax)
    yield Identity("K_т(z_2) = K, one material", accuracy.accuracy_factor(z1, pairs, C, fmin, fmin, fmax, fmax) - K)


def inverses_of_the_torque() -> Steps:
    """Gain, pairs and radius for a wanted torque put back into F11 (12) give it."""
    gain = synthesis.gain_for_torque(T, F, R, z1, z2, f1, f2)
    yield Identity("T(C) = T", direct.torque(F, R, z1, z2, gain, f1, f2) - T)
    pairs = synthesis.controlled_pairs_for_torque(T, F, R, z1, C, f1, f2)
    yield Identity("T(z_2) = T", direct.torque(F, R, z1, pairs, C, f1, f2) - T)
    radius = synthesis.mean_radius_for_torque(T, F, z1, z2, C, f1, f2)
    yield Identity("T(R) = T", direct.torque(F, radius, z1, z2, C, f1, f2) - T)


def inverses_of_indirect_accuracy() -> Steps:
    """Net gain, pairs and stiffness ratio for a wanted K_т put back into S21 (15) mended give it."""
    ends = fmin, fset, fmax
    net = _exact(synthesis.net_gain_for_accuracy_factor(*ends, c1, c2, z, K))
    yield Identity("K_т(κ) = K", indirect.accuracy_factor(*ends, c1, c2, z, net) - K)
    pairs = _exact(synthesis.pairs_for_accuracy_factor_indirect(*ends, c1, c2, q, K))
    yield Identity("K_т(z) = K", indirect.accuracy_factor(*ends, c1, c2, pairs, q) - K)
    loop = _exact(synthesis.net_loop_gain_for_accuracy_factor(fmin, fmin, fmax, c1, c2, K))
    printed = (c1 + c2) * (fmax - K * fmin) / (c1 * fmax * fmin * (K - 1))
    above, below = sp.symbols("g h", positive=True)
    difference = (loop - printed).subs(fmax, K * fmin + below).subs(K, 1 + above)
    yield Identity("set at f_min: (15) solved for zκ, 1 < K_т < f_max/f_min", _rooted(difference))
    ratio = synthesis.stiffness_ratio_for_accuracy_factor(*ends, z, q, K)
    yield Identity("K_т(c_2) = K", indirect.accuracy_factor(*ends, c1, ratio * c1, z, q) - K)
    yield Identity("K_т(c_1) = K", indirect.accuracy_factor(*ends, c2 / ratio, c2, z, q) - K)


def _exact(root: sp.Expr) -> sp.Expr:
    """Take the power 0.5 of an equation as a square root, so that its square is what stands under it."""
    return sp.nsimplify(root, rational=True)


def _rooted(expression: sp.Expr) -> sp.Expr:
    """Draw the roots of perfect squares."""
    half = sp.Rational(1, 2)
    return expression.replace(lambda e: e.is_Pow and e.exp == half, lambda e: sp.sqrt(sp.factor(e.base)))


def best_attainable_accuracy() -> Steps:
    """The best K_т of each variant: at the gain limit, at zC = 5, as the gain grows."""
    limit = direct.gain_limit_differentiated(z1, f1max)
    best = synthesis.best_accuracy_factor_differentiated(z1, z2, f1min, f2min, f1max)
    yield Identity("differentiated", best - accuracy.accuracy_factor(z1, z2, limit, f1min, f2min, f1max, f2max))
    one = synthesis.best_accuracy_factor_differentiated(z1, z2, fmin, fmin, fmax)
    yield Identity("one material: (m z_1 + z_2)/z", one - (fmax / fmin * z1 + z2) / (z1 + z2))
    driving = synthesis.best_accuracy_factor_all_driving(fmin, fmax, 5)
    own = accuracy.accuracy_factor(0, z, direct.gain_limit_all_driving(z), fmin, fmin, fmax, fmax)
    yield Identity("all-driving at zC = 5: m (1 + 5 f_min)/(1 + 5 f_max)", driving - own)
    yield Refutation("it depends on the limit", driving - synthesis.best_accuracy_factor_all_driving(fmin, fmax, 4))
    factor = indirect.accuracy_factor(fmin, fset, fmax, c1, c2, z, q)
    yield Identity("indirect: K_т → 1 as the gain grows, whatever the setting", sp.limit(factor, q, sp.oo) - 1)
