"""Analyses of a clutch: each a function ``(clutch, …) → Result``."""
