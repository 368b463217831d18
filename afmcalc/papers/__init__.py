"""What the papers say: formulas, misprints and claims (one list each), and what recomputes claims and figures."""
