"""A server and a browser, started once."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import Opened
from browser import chromium as started
from serving import CONFIGS, Served, serving, spec_in


@pytest.fixture(scope="session")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A server of a copy of the base clutch, which nothing may change."""
    folder = tmp_path_factory.mktemp("served")
    spec = spec_in(folder)
    with serving(folder, spec.name) as server:
        yield server
    assert spec.read_bytes() == (CONFIGS / "default.toml").read_bytes()
    assert [path.name for path in folder.iterdir()] == [spec.name]


@pytest.fixture(scope="session")
def forced(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A server that may write its spec."""
    folder = tmp_path_factory.mktemp("forced")
    with serving(folder, spec_in(folder).name, "--force") as server:
        yield server


@pytest.fixture
def spec(forced: Served) -> Iterator[Path]:
    """Its spec, as it was at the start; nothing else is beside it after a test."""
    file = spec_in(forced.folder)
    yield file
    assert [other.name for other in forced.folder.iterdir()] == [file.name]


@pytest.fixture
def serve(tmp_path: Path) -> Iterator[Any]:
    """Start servers in an empty folder: ``serve("clutch.toml", "--force")``."""
    started: list[Served] = []

    def start(*arguments: object) -> Served:
        started.append(Served(tmp_path, *arguments))
        return started[-1]

    yield start
    for server in started:
        server.end()


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    """The browser."""
    with started() as running:
        yield running


@pytest.fixture
def opened(chromium: Any) -> Iterator[Any]:
    """Open the page of a server: ``opened(served, width=375, scheme="dark")``."""
    pages: list[Opened] = []

    def open_page(served: Served, **settings: Any) -> Opened:
        pages.append(Opened(chromium, served, **settings))
        return pages[-1]

    yield open_page
    for page in pages:
        page.close()
