"""Variants of a clutch, one record each; whatever treats them differently reads the record.

A new variant of a law is one more record in ``VARIANTS``; no other module names a variant.
"""

from collections.abc import Callable, Container
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from .equations.arrays import Values

Paths: TypeAlias = tuple[str, ...]
"""Keys of a spec, each by its dotted path."""


@dataclass(frozen=True, eq=False)
class Variant:
    """One way a clutch regulates."""

    name: str
    """Name in a spec."""
    bypass: Callable[[Values, Values | None], Values]
    """``(z, driving_pairs as given or None)`` → z_1, the pairs that bypass the control unit; numbers or arrays."""
    needs: Paths = ()
    """Keys it cannot do without, beside those that every clutch needs."""
    requires: Paths = ()
    """Keys that every variant has and this one cannot do without."""
    takes: Paths = ()
    """Further keys it may have and not every variant has."""
    travels: bool = False
    """True if a sleeve travels between two springs: the indirect law, else the direct one."""
    gain_limit: Literal["breakaway", "recommended"] | None = None
    """Bound of the gain: above ``breakaway`` the bypass pairs alone carry more than the regulated torque (F11, after
    (20), S22 (24)); S22 recommends zC ≤ 5."""
    overload: bool = False
    """True if S22 treats its overload with a torque margin (of one material)."""
    example: str | None = None
    """The example spec to start from."""

    @property
    def keys(self) -> Paths:
        """Keys it has and not every variant has."""
        return self.takes + self.needs

    @property
    def controlled(self) -> bool:
        """True if it has a control unit."""
        return "control_unit" in self.keys

    @property
    def chooses_bypass(self) -> bool:
        """True if the spec chooses the pairs that bypass the control unit."""
        return "friction_group.driving_pairs" in self.keys

    def least_pairs(self, driving_pairs: Values | None = None) -> Any:
        """Smallest z: with a control unit one pair at least passes it."""
        return self.bypass(1, driving_pairs) + 1 if self.controlled else 1


VARIANTS: dict[str, Variant] = {
    variant.name: variant
    for variant in (
        Variant(  # ordinary friction safety clutch, no control unit
            name="conventional", bypass=lambda pairs, driving: pairs, example="conventional"
        ),
        Variant(  # Werner's clutch: some pairs bypass the control unit, the others pass it
            name="differentiated",
            bypass=lambda pairs, driving: 1 if driving is None else driving,
            needs=("control_unit",),
            takes=("friction_group.driving_pairs", "friction.driving", "friction.driven", "control_unit.release_lag"),
            gain_limit="breakaway",
            overload=True,
            example="default",
        ),
        Variant(  # all torque passes the control unit
            name="all-driving",
            bypass=lambda pairs, driving: 0,
            needs=("control_unit",),
            takes=("control_unit.release_lag",),
            gain_limit="recommended",
            overload=True,
            example="all-driving",
        ),
        Variant(  # the release force moves a sleeve that slackens the closing spring (S21)
            name="indirect",
            travels=True,
            bypass=lambda pairs, driving: 0,
            needs=("control_unit", "control_unit.hub_diameter", "control_unit.key_friction", "control_spring"),
            requires=("closing_spring.stiffness",),
            takes=("control_unit.gain_slope", "control_unit.pocket", "control_unit.sleeve_mass", "drive.hub_inertia"),
            example="indirect",
        ),
    )
}
"""Name in a spec → its record."""


def special_keys() -> dict[str, tuple[str, ...]]:
    """Keys that only some variants have → those variants."""
    special: dict[str, tuple[str, ...]] = {}
    for variant in VARIANTS.values():
        for key in variant.keys:
            special[key] = (*special.get(key, ()), variant.name)
    return special


def variants_of(path: str) -> tuple[str, ...]:
    """Variants that have the key at a dotted path; empty when all have."""
    having = [variants for key, variants in special_keys().items() if f"{path}.".startswith(f"{key}.")]
    return min(having, key=len) if having else ()


def foreign_keys(given: Container[str], variant: str) -> list[str]:
    """Paths that are given and that the variant does not have; a block stands for its keys."""
    foreign = [path for path, having in special_keys().items() if path in given and variant not in having]
    return [path for path in foreign if "." not in path or path.partition(".")[0] not in foreign]
