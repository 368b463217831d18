"""Pages made once for the run, on one day; drawn only where a drawing is looked at."""

import functools
from importlib import import_module

import html5lib
import pytest
from conftest import CONFIGS, FRAME


@pytest.fixture(autouse=True, scope="session")
def _a_day():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1767225600")
        yield


@pytest.fixture(scope="session")
def drawn(answered):
    """The page of a shipped spec, with its drawings."""

    def page(name, *options):
        run = answered("report", CONFIGS / f"{name}.toml", *options)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def framed(afmcalc):
    """The page of any arguments, with frames in place of its drawings."""
    import_module("afmcalc.render.report")  # which takes longer than a page

    @functools.cache
    def page(*arguments, stdin=""):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)
            run = afmcalc("report", *arguments, stdin=stdin)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def parsed():
    """The tree of a page, which is read once; a page that is not valid HTML is refused."""
    return functools.cache(html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse)


@pytest.fixture(scope="session")
def report(framed, parsed):
    """The page of a shipped spec, with frames in place of its drawings; the first is made here."""
    parsed(framed(CONFIGS / "default.toml"))
    return lambda name="default", *options: framed(CONFIGS / f"{name}.toml", *options)


@pytest.fixture(scope="session")
def book():
    """Content of the handbook in a language."""
    from afmcalc.analysis.handbook_content import handbook

    return functools.cache(handbook)
