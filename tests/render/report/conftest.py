"""Reports, each page made once."""

import functools
from collections.abc import Callable

import pytest
from conftest import CONFIGS


@pytest.fixture(autouse=True, scope="session")
def _a_day():
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SOURCE_DATE_EPOCH", "1767225600")
        yield


@pytest.fixture(scope="session")
def report(afmcalc, _a_day) -> Callable[..., str]:
    """The page of a shipped spec, ``report("indirect", "C=2")`` with overrides."""

    @functools.cache
    def page(name: str = "default", *overrides: str) -> str:
        run = afmcalc("report", CONFIGS / f"{name}.toml", *(part for text in overrides for part in ("--set", text)))
        assert (run.code, run.err) == (0, "")
        return run.out

    return page
