"""Keys that earlier versions had: an error that says what to do instead."""

import pytest

from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.keys import keys
from afmcalc.spec.removed import REMOVED


@pytest.mark.parametrize("path", [path for path in REMOVED if not path.startswith("fixed.")])
def test_a_removed_key_says_what_to_do(path):
    assert path not in keys()
    block, name = path.split(".")
    data = resolved(read_spec())
    data.setdefault(block, {})[name] = 1
    for refused in (lambda: make_spec(data), lambda: read_spec(None, [f"{path}=1"])):
        with pytest.raises(AfmcalcError, match="unknown key.* since 0.4: .*leave the key out"):
            refused()
