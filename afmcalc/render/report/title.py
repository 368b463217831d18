"""Title block of a report, and the spec as given at its end."""

import json
import os
from collections.abc import Mapping
from datetime import UTC, datetime

from ...errors import AfmcalcError, given
from ...messages import say, spoken
from ...spec import Spec
from ...spec.edit import respecified
from ...spec.models import TitleBlock
from ...spec.parse import Source, parse
from ...spec.write import annotated


def title_block(spec: Spec, entries: Mapping[str, str | None]) -> TitleBlock:
    """Return the [report] block of the spec under further entries, dated today where neither has a date."""
    entered = {f"report.{name}": text for name, text in entries.items() if text is not None}
    dated = {} if spec.report and spec.report.date else {"report.date": today()}
    return given(respecified(spec, dated | entered).report)


def text_as_given(source: Source) -> str:
    """Return the text of a spec; of a command's JSON that of its spec block.

    One that ships has its comments in the language of the user, and says so.
    """
    text = source.text
    ships = source.startswith("example:")
    if ships and spoken() != "en":
        text = say("# {file}, its comments translated", file=source) + f"\n{annotated(text)}"
    if text.lstrip().startswith("{"):
        text = json.dumps(parse(source), indent=2, ensure_ascii=False)
    return text.strip("\n")


_DIGITS = 11
"""Of seconds since 1970: those of the year 5000."""


def today() -> str:
    """Today, or the day of SOURCE_DATE_EPOCH where a build must be repeatable."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not epoch:
        return datetime.now().date().isoformat()
    if not epoch.isdecimal() or len(epoch) > _DIGITS:
        raise AfmcalcError("SOURCE_DATE_EPOCH = {epoch!r:.40}: seconds since 1970 are wanted", epoch=epoch)
    return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()
