"""What a search asks of a variant."""

from dataclasses import dataclass
from functools import cached_property

from ...arrays import Values
from ...equations import direct


@dataclass(frozen=True)
class Kind:
    """A variant as far as a search treats it differently."""

    name: str

    @cached_property
    def controlled(self) -> bool:
        """Whether it has a control unit."""
        return self.name != "conventional"

    @cached_property
    def chooses_bypass(self) -> bool:
        """Whether the pairs that bypass the control unit are chosen."""
        return self.name == "differentiated"

    @cached_property
    def travels(self) -> bool:
        """Whether a sleeve travels between two springs."""
        return self.name == "indirect"

    def bypass(self, pairs: Values, driving: Values) -> Values:
        """z_1."""
        if self.chooses_bypass:
            return driving
        return 0.0 * pairs if self.controlled else pairs

    @cached_property
    def limited(self) -> bool:
        """Whether there is a gain at which the law ceases to describe the whole slip."""
        return self.controlled and not self.travels

    def gain_limit(self, bypass: Values, controlled: Values, friction_max: float) -> Values:
        """Largest such gain."""
        limit: Values
        if self.chooses_bypass:
            limit = direct.gain_limit_differentiated(bypass, friction_max)
        else:
            limit = direct.gain_limit_all_driving(controlled)
        return limit

    @cached_property
    def no_clutch(self) -> str:
        """Name under which candidates count that cannot be built or do not adapt."""
        return "gain_threshold" if self.travels else "pairs"
