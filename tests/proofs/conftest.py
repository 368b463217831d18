"""A proof is a test."""

from functools import wraps

import pytest
from proofs.symbols import is_proof, prove


def pytest_pycollect_makeitem(collector, name, obj):
    """Collect the proofs of a module under their own names."""
    if not is_proof(name, obj):
        return None

    @wraps(obj)
    def test():
        prove(obj)

    del test.__wrapped__
    return pytest.Function.from_parent(collector, name=name, callobj=test)
