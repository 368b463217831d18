"""Pages made once for the test run, on a fixed date; their drawings are made only if a test looks at them."""

import functools
from html.parser import HTMLParser
from importlib import import_module
from xml.etree import ElementTree

import pytest
from conftest import CONFIGS, FRAME


@pytest.fixture(autouse=True, scope="session")
def _a_day():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1767225600")
        yield


@pytest.fixture(scope="session")
def drawn(answered):
    """Function that returns the report of a shipped spec, with its drawings."""

    def page(name, *options):
        run = answered("report", CONFIGS / f"{name}.toml", *options)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


@pytest.fixture(scope="session")
def framed(afmcalc):
    """Function that returns the report for any arguments, with empty frames in place of its drawings."""
    import_module("afmcalc.render.report")  # importing it takes longer than a page

    @functools.cache
    def page(*arguments, stdin=""):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)
            run = afmcalc("report", *arguments, stdin=stdin)
        assert (run.code, run.err) == (0, "")
        return run.out

    return page


class _Tree(HTMLParser):
    """Tree of a page that closes all tags but those without an end tag; several times as fast as html5lib."""

    def __init__(self, html):
        super().__init__()
        self.builder, self.open = ElementTree.TreeBuilder(), []
        self.feed(html)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.builder.start(tag, {name: value or "" for name, value in attrs})
        self.open.append(tag)
        if tag in ("meta", "br", "col", "hr", "wbr"):
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        self.builder.end(tag)

    def handle_data(self, data):
        self.builder.data(data)


@pytest.fixture(scope="session")
def parsed():
    """Function that returns the tree of a page, and parses each page once."""
    return functools.cache(lambda html: _Tree(html.strip()).builder.close())


@pytest.fixture(scope="session")
def report(framed, parsed):
    """Function that returns the report of a shipped spec without drawings; the default one is made at once."""
    parsed(framed(CONFIGS / "default.toml"))
    return lambda name="default", *options: framed(CONFIGS / f"{name}.toml", *options)


@pytest.fixture(scope="session")
def book():
    """Content of the handbook in a language."""
    from afmcalc.analysis.handbook_content import handbook

    return functools.cache(handbook)
