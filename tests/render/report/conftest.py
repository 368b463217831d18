"""Reports, each page made once; drawn only where a drawing is looked at."""

import functools
import re
from collections.abc import Callable
from typing import Any

import html5lib
import pytest
from conftest import CONFIGS


@pytest.fixture(autouse=True, scope="session")
def _a_day():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1767225600")
        yield


@pytest.fixture(scope="session")
def report(afmcalc, _a_day) -> Callable[..., str]:
    """The page of a shipped spec, drawn."""

    @functools.cache
    def page(name: str = "default") -> str:
        run = afmcalc("report", CONFIGS / f"{name}.toml")
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def undrawn(afmcalc, _a_day) -> Callable[..., str]:
    """The page of any arguments, with frames in place of its drawings."""

    @functools.cache
    def page(*arguments: object, stdin: str = "") -> str:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: "<svg viewBox='0 0 7 4'></svg>")
            run = afmcalc("report", *arguments, stdin=stdin)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def parsed() -> Callable[..., Any]:
    """The tree of a page, which is read once, without its drawings; a page that is not valid HTML is refused."""

    @functools.cache
    def tree(page: str, *, drawn: bool = False) -> Any:
        text = page if drawn else re.sub("<svg.*?</svg>", "<svg></svg>", page, flags=re.DOTALL)
        return html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(text)

    return tree
