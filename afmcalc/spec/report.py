"""The [report] block: what a report's title block says beside the clutch."""

from datetime import date
from typing import Annotated

from pydantic import BeforeValidator

from .fields import Block, Name, key_field


def _as_text(value: object) -> object:
    """A revision 2 and a TOML date need no quotes."""
    if isinstance(value, date):
        return value.isoformat()
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


Entry = Annotated[Name, BeforeValidator(_as_text)]


class TitleBlock(Block):
    """What stands in the title block of a report; each is text."""

    project: Entry | None = key_field("project the clutch belongs to")
    drawing: Entry | None = key_field("number of the drawing")
    revision: Entry | None = key_field("revision of the calculation")
    author: Entry | None = key_field("who calculated")
    checked: Entry | None = key_field("who checked")
    norm_control: Entry | None = key_field("who checked it against the standards")
    approved: Entry | None = key_field("who approved")
    date: Entry | None = key_field("date of the calculation")
    organisation: Entry | None = key_field("who answers for the calculation")
