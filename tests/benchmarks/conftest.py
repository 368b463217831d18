"""Figures are printed as they are measured."""

from collections.abc import Callable

import pytest


@pytest.fixture
def report(capsys: pytest.CaptureFixture[str]) -> Callable[[str, float, float], None]:
    """Print a ratio and hold it to its limit."""

    def hold(name: str, ratio: float, limit: float) -> None:
        with capsys.disabled():
            print(f"\n{name}: {ratio:.4g} (limit {limit:g})", end="")
        assert ratio <= limit

    return hold
