"""What every engine offers to the analyses."""

from typing import Any, NamedTuple, Protocol

from ..arrays import Values
from ..findings import Finding
from ..spec.models import Method, Range, Spec


class Point(NamedTuple):
    """State of the slipping clutch at one friction, SI."""

    torque: Any
    normal_force: Any
    release_force: Any
    travel: Any | None
    """Axial travel of the thrust sleeve, m; None where there is no sleeve."""


class Clutch(Protocol):
    """A clutch that can be asked; parameters are floats or, in a sweep, arrays."""

    @property
    def spec(self) -> Spec:
        """The spec it was built from."""

    @property
    def friction(self) -> tuple[Range, Range]:
        """Ranges of f_1 and f_2 (twice the same with one material)."""

    @property
    def closing_force(self) -> Values:
        """F_п as set, N."""

    @property
    def pack_force_at_rest(self) -> Values:
        """Force on the pack of the clutch at rest, N."""

    @property
    def mean_radius(self) -> Values:
        """R_cp, m."""

    @property
    def bypass_pairs(self) -> Values:
        """z_1, pairs that bypass the control unit."""

    @property
    def gain(self) -> Values:
        """C."""

    @property
    def reduced_gain(self) -> Values:
        """z C or z_2 C."""

    @property
    def gain_limit(self) -> Values | None:
        """Largest gain at which the law describes the whole slip."""

    @property
    def nominal_torque(self) -> Values:
        """T_н, N·m."""

    @property
    def torque_max(self) -> Values:
        """Largest sustained torque along the common path, N·m."""

    @property
    def accuracy_factor(self) -> Values:
        """K_т along the common path."""

    @property
    def accuracy_factor_worst_case(self) -> Values:
        """K_т with f_1 and f_2 independent."""

    @property
    def accuracy_factor_peak(self) -> Values:
        """K_т by breakaway peaks."""

    def torque_per_force(self, method: Method | None = None) -> Any:
        """T/F_п at the friction of a setting, m; by default the spec's own."""

    def torque(self, friction: Any, friction_driven: Any = None) -> Any:
        """Sustained slip torque, N·m."""

    def ball_torque(self, friction: Any, friction_driven: Any = None) -> Any:
        """Torque that passes the balls, N·m."""

    def point(self, friction: Any, friction_driven: Any = None) -> Point:
        """Torque, forces and travel at one friction."""

    def sensitivity(self) -> dict[str, float]:
        """Elasticities of K_т by spec path."""

    def findings(self) -> list[Finding]:
        """What a designer should know."""
