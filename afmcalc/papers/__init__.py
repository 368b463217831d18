"""Papers: lists of their formulas, misprints and claims, and code that recomputes claims and figures."""

PAPERS = {"F11": "fokin2011", "S19": "shishkarev2019", "S21": "shishkarev2021", "S22": "shishkarev2022"}
"""Key of a paper → module with its figures and claims."""

FIGURES = ("F11-2", "S19-2", "S21-2", "S21-4", "S22-1", "S22-2", "S22-3", "S22-4")
"""Paper and number of each figure; a function of the paper's module calculates it, such as ``figure_2``."""
