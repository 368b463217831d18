"""Reports, each page made once; drawn only where a drawing is looked at."""

import functools
from collections.abc import Callable
from typing import Any

import html5lib
import pytest
from conftest import CONFIGS, FRAME


@pytest.fixture(autouse=True, scope="session")
def _a_day():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1767225600")
        yield


@pytest.fixture(scope="session")
def drawn(afmcalc, _a_day) -> Callable[..., str]:
    """The page of a shipped spec, with its drawings."""

    @functools.cache
    def page(name: str, *options: str) -> str:
        run = afmcalc("report", CONFIGS / f"{name}.toml", *options)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def framed(afmcalc, _a_day) -> Callable[..., str]:
    """The page of any arguments, with frames in place of its drawings."""

    @functools.cache
    def page(*arguments: object, stdin: str = "") -> str:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)
            run = afmcalc("report", *arguments, stdin=stdin)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def report(framed) -> Callable[..., str]:
    """The page of a shipped spec, with frames in place of its drawings."""
    return lambda name="default": framed(CONFIGS / f"{name}.toml")


@pytest.fixture(scope="session")
def parsed() -> Callable[[str], Any]:
    """The tree of a page, which is read once; a page that is not valid HTML is refused."""
    return functools.cache(html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse)
