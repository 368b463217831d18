"""What is on the layers of a drawing, and in what colour."""

LAYERS = {
    "SLEEVE_1": ("sleeve with the profiled wall", 8, "#6e6e6e"),
    "SLEEVE_2": ("the other sleeve", 8, "#6e6e6e"),
    "POCKET_1": ("pocket of the profiled wall: to cut", 7, "#111111"),
    "POCKET_2": ("pocket of the other sleeve: to cut", 7, "#111111"),
    "PATH": ("path of the ball's centre in the profiled sleeve", 3, "#1a7f37"),
    "CUTTER": ("path of the cutter's centre in the profiled sleeve", 1, "#b3261e"),
    "BALL": ("the ball at the stop", 5, "#0b57d0"),
    "DIMENSIONS": ("dimensions and notes", 8, "#6e6e6e"),
}
"""Layer → what it shows, its number among AutoCAD's colours, its colour."""

CREATOR = "afmcalc plot"
"""What a drawing says it was made by."""
MM = 1e3
