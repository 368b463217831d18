"""Jinja templates of the page, with filters and functions that typeset blocks of a report."""

from functools import cache
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from ..messages import printable, say, translate
from ..render.report.blocks import Block
from ..render.report.html import fragment, inline
from ..render.report.page import findings_of, judged, quantities
from ..render.report.pieces import cell, said
from ..render.report.words import titled


@cache
def template(name: str) -> Template:
    """Template by its file name; its texts are translated only when rendered, so one template serves all languages."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        optimized=False,
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=lambda value: printable(value, lines=True) if type(value) is str else value,
    )
    environment.filters |= {
        "symbol": lambda words: Markup(inline(said(words))),
        "cell": lambda words: Markup(inline(cell(words))),
        "translate": translate,
    }
    environment.globals.update(
        _=say, set=_set, titled=titled, judged=judged, quantities=quantities, findings_of=findings_of
    )
    return environment.get_template(name)


def _set(*blocks: Block) -> Markup:
    return Markup(fragment(blocks))
