"""Specs of a clutch: reading, checking and writing them."""

from .make import make_spec
from .models import Spec, resolved
from .read import read_spec
from .write import to_toml

__all__ = ["Spec", "make_spec", "read_spec", "resolved", "to_toml"]
