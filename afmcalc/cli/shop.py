"""What the command that draws writes for the shop; and the clutches it draws."""

from typing import TYPE_CHECKING

from ..errors import AfmcalcError, need
from ..messages import say
from .files import write, write_file
from .options import Common
from .run import build_from

if TYPE_CHECKING:
    from ..analysis.answers import Answers
    from ..analysis.figures import Request


def for_the_shop(what: str, request: "Request", ending: str | None, common: Common) -> None:
    """Write the pocket in true millimetres, and the profile of its wall.

    Raises:
        AfmcalcError: another plot, a picture that is none for the shop, a pocket or a cutter that cannot be.
    """
    from ..analysis.figures import shop_drawing_of
    from ..render import shop

    if ending == "dxf":
        need("cad")
    if ending in ("png", "pdf"):
        raise AfmcalcError(say("--profile goes with -o FILE.dxf or FILE.svg, or stands alone"))
    subjects = answers_of(what, request, common)
    with common.bar():
        drawing = shop_drawing_of(what, request._replace(subjects=subjects))
    if ending is not None:
        assert common.output is not None
        content = shop.dxf(drawing) if ending == "dxf" else shop.svg(drawing)
        write_file(common.output, content, force=common.force)
        common.wrote(say("wrote {output}", output=common.output))
    if request.profile is not None:
        write(shop.profile(drawing), request.profile, force=common.force)
        if request.profile != "-":
            common.wrote(say("wrote {output}", output=request.profile))


def length(name: str, text: str | None) -> float | None:
    """Read the length that an option gives, with its unit.

    Raises:
        AfmcalcError: none, or not above 0.
    """
    from ..spec.quantity import parse_quantity

    if text is None:
        return None
    try:
        value = parse_quantity(text, "m")
    except ValueError as error:
        raise AfmcalcError(say("--{name} {text}: {why}", name=name, text=text, why=error)) from None
    if value <= 0:
        raise AfmcalcError(say("--{name} {text}: must be greater than 0", name=name, text=text))
    return value


def answers_of(what: str, request: "Request", common: Common) -> "list[Answers]":
    """Read and build the clutches that are drawn."""
    from ..analysis.answers import Answers
    from ..spec.quantity import doubts

    if request.subjects.count("-") > 1:
        raise AfmcalcError(say("standard input (-) can be read once only"))
    sources = list(request.subjects) or [None]
    clutches = [build_from(source, common, what) for source in sources]
    for asked in (each for clutch in clutches for each in doubts(clutch.spec.label.doubts)):
        common.note(asked.message)  # a plot has no findings
    return [Answers(each, model=request.model or "mean-stress") for each in clutches]
