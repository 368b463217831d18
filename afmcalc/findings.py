"""Findings: what a designer should know about a legal design."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from .arrays import finite
from .messages import sentence
from .source import Unlikely

Level = Literal["info", "warning", "error"]


@dataclass(frozen=True)
class Finding:
    """One remark on a design, with the number it is about and the number it is held against."""

    level: Annotated[
        Level, Field(description="info: worth knowing; warning: not as the law or the wish says; error: must change")
    ]
    code: Annotated[str, Field(description="short name that scripts may rely on")]
    message: Annotated[str, Field(description="what it means, in a sentence")]
    value: Annotated[float | None, Field(description="the number in question, SI")] = None
    limit: Annotated[float | None, Field(description="what it is held against, SI")] = None
    path: Annotated[str | None, Field(description="spec key it belongs to")] = None


def finding(
    code: str,
    level: Level,
    *,
    value: float | None = None,
    limit: float | None = None,
    path: str | None = None,
    **values: object,
) -> Finding:
    """Make a finding whose sentence is that of its code in ``messages.FINDINGS``.

    Args:
        code: short name that scripts may rely on; one with several sentences is followed by ``/case``.
        level: how grave it is.
        value: the number in question, SI; the sentence may show it as ``{value}``.
        limit: what it is held against, SI; ``{limit}``.
        path: spec key it belongs to; ``{path}``.
        values: what else the sentence shows, SI.

    Raises:
        OverflowError: a number is beyond the range of numbers: it would be told as nan or inf.
    """
    for each in (value, limit, *values.values()):
        if isinstance(each, float):
            finite(each)
    said = {"value": value, "limit": limit, "path": path, **values}
    number, bound = (each if each is None or type(each) is int else float(each) for each in (value, limit))
    return Finding(level, code.partition("/")[0], sentence(code, said), number, bound, path)


def doubts(found: Iterable[Unlikely]) -> list[Finding]:
    """Ask after numbers without a unit that may be meant in another than SI."""
    return [
        finding("number-without-unit", "warning", value=each.value, path=each.path, given=each.given, meant=each.meant)
        for each in found
    ]


def worst(findings: list[Finding]) -> Level | None:
    """Return the gravest level present."""
    order: tuple[Level, ...] = ("error", "warning", "info")
    return next((level for level in order if any(finding.level == level for finding in findings)), None)
