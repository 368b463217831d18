"""What the papers say: their formulas, misprints, claims and figures."""
