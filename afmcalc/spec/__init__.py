"""What a clutch is: reading, checking and writing specs."""

from .models import Spec
from .reading import make_spec, read_spec
from .writing import resolved, to_toml

__all__ = ["Spec", "make_spec", "read_spec", "resolved", "to_toml"]
