"""Sweeps: any numeric key of the spec over a range of values."""
