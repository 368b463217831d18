"""Variants of a clutch, one record each; other modules read all differences between them from the records.

A new variant of a law is one more record in ``VARIANTS``; no other module names a variant.
"""

from collections.abc import Callable, Container
from dataclasses import dataclass
from typing import Any, Literal

from .equations.arrays import Values

Paths = tuple[str, ...]
"""Dotted paths of spec keys."""


@dataclass(frozen=True, eq=False)
class Variant:
    """One variant of a clutch: pairs that bypass its control unit, keys of its spec, limits."""

    name: str
    """Name in a spec."""
    bypass: Callable[[Values, Values | None], Values]
    """``(z, driving_pairs as given or None)`` → z_1, the number of pairs that bypass the control unit, or arrays."""
    needs: Paths = ()
    """Required keys that not every variant has."""
    requires: Paths = ()
    """Keys that every variant has and that are required in this variant, but optional in others."""
    takes: Paths = ()
    """Optional keys that not every variant has."""
    travels: bool = False
    """True if a sleeve travels between two springs (indirect law); False for the direct law."""
    gain_limit: Literal["breakaway", "recommended"] | None = None
    """Bound of the gain: above ``breakaway`` the bypass pairs alone carry more than the regulated torque (F11, after
    (20), S22 (24)); ``recommended`` is zC ≤ 5 (S22); None: no bound."""
    overload: bool = False
    """True if S22 covers the overload of this variant with a torque margin (for pairs of one material)."""
    example: str | None = None
    """Name of the example spec from which to start."""

    @property
    def keys(self) -> Paths:
        """Required and optional keys that not every variant has."""
        return self.takes + self.needs

    @property
    def controlled(self) -> bool:
        """True if the variant has a control unit."""
        return "control_unit" in self.keys

    def least_pairs(self, driving_pairs: Values | None = None) -> Any:
        """Smallest number of pairs z: a control unit needs at least one pair that does not bypass it."""
        return self.bypass(1, driving_pairs) + 1 if self.controlled else 1


VARIANTS: dict[str, Variant] = {
    variant.name: variant
    for variant in (
        Variant(  # ordinary friction safety clutch, no control unit
            name="conventional", bypass=lambda pairs, driving: pairs, example="conventional"
        ),
        Variant(  # Werner's clutch: some pairs bypass the control unit, the others act through it
            name="differentiated",
            bypass=lambda pairs, driving: 1 if driving is None else driving,
            needs=("control_unit",),
            takes=("friction_group.driving_pairs", "friction.driving", "friction.driven", "control_unit.release_lag"),
            gain_limit="breakaway",
            overload=True,
            example="default",
        ),
        Variant(  # all torque acts through the control unit
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
            takes=(
                "control_unit.gain_slope",
                "control_unit.pocket",
                "control_unit.sleeve_mass",
                "drive.hub_inertia",
                "control_unit.pressure_disc_key",
            ),
            example="indirect",
        ),
    )
}
"""Name in a spec → its record."""


def special_keys() -> dict[str, tuple[str, ...]]:
    """Path of a key that only some variants have → names of these variants."""
    special: dict[str, tuple[str, ...]] = {}
    for variant in VARIANTS.values():
        for key in variant.keys:
            special[key] = (*special.get(key, ()), variant.name)
    return special


def variants_of(path: str) -> tuple[str, ...]:
    """Names of the variants that have the key at a dotted path; empty if all variants have the key."""
    having = [variants for key, variants in special_keys().items() if f"{path}.".startswith(f"{key}.")]
    return min(having, key=len) if having else ()


def foreign_keys(given: Container[str], variant: str) -> list[str]:
    """Given paths of keys that a variant lacks; for a block that the variant lacks, only the path of the block."""
    foreign = [path for path, having in special_keys().items() if path in given and variant not in having]
    return [path for path in foreign if "." not in path or path.partition(".")[0] not in foreign]
