"""Specs of a clutch: reading, checking and writing them."""

from .models import Spec, resolved
from .read import make_spec, read_spec
from .write import to_toml

__all__ = ["Spec", "make_spec", "read_spec", "resolved", "to_toml"]
