"""The variants of a clutch: one record each, asked by everything that treats them differently.

A further variant of a law is one more record in ``VARIANTS``, and nothing else: no other module names one.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from .equations import direct
from .equations.arrays import Values

Law = Literal["direct", "indirect"]
Paths: TypeAlias = tuple[str, ...]
"""Keys of a spec, each by its dotted path."""


@dataclass(frozen=True, eq=False)
class GainLimit:
    """Largest gain at which the direct law describes the whole slip: C times the pairs of one group is bounded."""

    most: Callable[[Values, Values], Values]
    """``(pairs that count, f_1max)`` → the largest C; a hyperbola, so of C it gives the most pairs."""
    code: str
    """Finding on a clutch beyond the limit."""
    quantity: str
    """What is bounded, in words."""
    symbol: str
    """The bound, in symbols."""
    rule: str
    """The limit itself, in symbols."""
    reduced: float | None = None
    """Bound of the reduced gain, where the limit is stated so: the controlled pairs count. Else the bypass pairs do."""

    def gain(self, bypass: Values, controlled: Values, friction_max: Values) -> Any:
        """Largest C for z_1, z_2 and f_1max."""
        return self.most(bypass if self.reduced is None else controlled, friction_max)

    def stated(self, gain: Values, reduced_gain: Values, limit: Values) -> tuple[Values, Values]:
        """Value and bound as the limit is stated: C, or the reduced gain."""
        return (gain, limit) if self.reduced is None else (reduced_gain, float(self.reduced))


@dataclass(frozen=True, eq=False)
class Variant:
    """One way a clutch regulates."""

    name: str
    """As a spec calls it."""
    law: Law
    """The engine that calculates it."""
    description: str
    bypass: Callable[[Values, Values | None], Values]
    """``(z, driving_pairs as given or None)`` → z_1, the pairs that bypass the control unit; numbers or arrays."""
    needs: Paths = ()
    """Keys it cannot do without, beside those that every clutch needs."""
    requires: Paths = ()
    """Keys that every variant has and this one cannot do without."""
    takes: Paths = ()
    """Further keys it may have and not every variant has."""
    gain_limit: GainLimit | None = None
    overload: bool = False
    """Whether S22 treats its overload with a torque margin (of one material)."""
    example: str | None = None
    """The example spec to start from."""

    @property
    def keys(self) -> Paths:
        """Keys it has and not every variant has."""
        return self.takes + self.needs

    @property
    def controlled(self) -> bool:
        """Whether it has a control unit."""
        return "control_unit" in self.keys

    @property
    def chooses_bypass(self) -> bool:
        """Whether the spec chooses the pairs that bypass the control unit."""
        return "friction_group.driving_pairs" in self.keys

    @property
    def unlike(self) -> bool:
        """Whether its two groups of pairs may have materials of their own."""
        return "friction.driving" in self.keys

    @property
    def travels(self) -> bool:
        """Whether a sleeve travels between two springs."""
        return self.law == "indirect"

    def least_pairs(self, driving_pairs: Values | None = None) -> Any:
        """Smallest z: with a control unit one pair at least passes it."""
        return self.bypass(1, driving_pairs) + 1 if self.controlled else 1


_breakaway: Any = direct.DIFFERENTIATED["gain_limit"]
_recommended: Any = direct.ALL_DRIVING["gain_limit"]

BREAKAWAY_LIMIT = GainLimit(
    most=_breakaway,
    code="gain-above-limit",
    quantity="feedback gain",
    symbol="C ≤ 1/(z_1 f_1max)",
    rule="1/(z_1 f_1max)",
)
"""Above it the bypass pairs alone carry more than the regulated torque (F11, after (20), S22 (24))."""

REDUCED_LIMIT = GainLimit(
    most=lambda pairs, friction_max: _recommended(pairs),
    code="reduced-gain-above-limit",
    quantity="reduced gain",
    symbol="zC ≤ 5",
    rule="zC = 5",
    reduced=5,
)
"""Recommended by S22."""

VARIANTS: dict[str, Variant] = {
    variant.name: variant
    for variant in (
        Variant(
            name="conventional",
            law="direct",
            description="ordinary friction safety clutch, no control unit",
            bypass=lambda pairs, driving: pairs,
            example="conventional",
        ),
        Variant(
            name="differentiated",
            law="direct",
            description="Werner's clutch: some pairs bypass the control unit, the others pass it",
            bypass=lambda pairs, driving: 1 if driving is None else driving,
            needs=("control_unit",),
            takes=("friction_group.driving_pairs", "friction.driving", "friction.driven", "control_unit.release_lag"),
            gain_limit=BREAKAWAY_LIMIT,
            overload=True,
            example="default",
        ),
        Variant(
            name="all-driving",
            law="direct",
            description="all torque passes the control unit",
            bypass=lambda pairs, driving: 0,
            needs=("control_unit",),
            takes=("control_unit.release_lag",),
            gain_limit=REDUCED_LIMIT,
            overload=True,
            example="all-driving",
        ),
        Variant(
            name="indirect",
            law="indirect",
            description="the release force moves a sleeve that slackens the closing spring (S21)",
            bypass=lambda pairs, driving: 0,
            needs=("control_unit", "control_unit.hub_diameter", "control_unit.key_friction", "control_spring"),
            requires=("closing_spring.stiffness",),
            takes=(
                "control_unit.gain_slope",
                "control_unit.pocket",
                "control_unit.sleeve_mass",
                "drive.hub_inertia",
            ),
            example="indirect",
        ),
    )
}
"""Name in a spec → its record."""
