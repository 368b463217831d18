"""What the papers say: formulas, misprints and claims (one list each), and what recomputes claims and figures."""

PAPERS = {"F11": "fokin2011", "S19": "shishkarev2019", "S21": "shishkarev2021", "S22": "shishkarev2022"}
"""Key of a paper → module of its figures and claims."""
