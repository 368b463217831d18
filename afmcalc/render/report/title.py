"""Date of a report, and the text of the spec as given, for the end of the report."""

import json
import os
from datetime import UTC, datetime

from ...errors import AfmcalcError
from ...messages import say, spoken
from ...spec.parse import Source, parse
from ...spec.write import annotated


def text_as_given(source: Source) -> str:
    """Return the text of a spec or, if the source is JSON of a command, the text of its ``spec``.

    If the user's language is not English, the comments of a built-in example are translated; the first line says so.
    """
    text = source.text
    ships = source.startswith("example:")
    if ships and spoken() != "en":
        text = say("# {file}, its comments translated", file=source) + f"\n{annotated(text)}"
    if text.lstrip().startswith("{"):
        text = json.dumps(parse(source), indent=2, ensure_ascii=False)
    return text.strip("\n")


_DIGITS = 11
"""Largest number of digits of the seconds since 1970: enough up to the year 5000."""


def today() -> str:
    """Today's date, or the date in SOURCE_DATE_EPOCH, which makes a build repeatable."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not epoch:
        return datetime.now().date().isoformat()
    if not epoch.isdecimal() or len(epoch) > _DIGITS:
        raise AfmcalcError("SOURCE_DATE_EPOCH = {epoch!r:.40}: seconds since 1970 are wanted", epoch=epoch)
    return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()
