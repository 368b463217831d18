"""Pages in this process; a server and a browser, started once."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import Opened
from pages import Site, spec_in
from serving import Served


@pytest.fixture(scope="session")
def site(afmcalc: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """The page for a copy of the base clutch; asserts at the end that its file is unchanged."""
    spec = spec_in(tmp_path_factory.mktemp("site"))
    before = spec.read_bytes()
    yield Site(afmcalc, spec)
    assert spec.read_bytes() == before
    assert [*spec.parent.iterdir()] == [spec]


@pytest.fixture(scope="session")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A server, as a process, that may write its spec, a copy of the base clutch."""
    server = Served(spec_in(tmp_path_factory.mktemp("served")), "--force")
    yield server
    server.end()


@pytest.fixture
def serve(tmp_path: Path) -> Iterator[Any]:
    """Start servers of a spec in an empty folder: ``serve("drive", "--force")``."""
    servers: list[Served] = []

    def start(name: str = "default", *arguments: object) -> Served:
        servers.append(Served(spec_in(tmp_path, name), *arguments))
        return servers[-1]

    yield start
    for server in servers:
        server.end()


@pytest.fixture
def opened(chromium: Any) -> Iterator[Any]:
    """Open the page of a server: ``opened(served, width=375, scheme="dark")``; its console must stay empty."""
    pages: list[Opened] = []

    def open_page(served: Served, **settings: Any) -> Opened:
        pages.append(Opened(chromium, served, **settings))
        return pages[-1]

    yield open_page
    for page in pages:
        page.close()
        assert page.problems == []
