"""The profile of the wall as CSV, in millimetres: path of the ball's centre, wall, path of the cutter."""

import csv
import io
import math

from ...analysis.shop import CutterPoint, ShopDrawing
from .layers import MM


def profile(drawing: ShopDrawing) -> str:
    """Write the wall of the profiled sleeve from floor to face; places below the stop have a travel below 0."""
    stream = io.StringIO()
    rows = csv.writer(stream, lineterminator="\n")
    rows.writerow(f"{name} [{'deg' if name == 'wall_angle' else 'mm'}]" for name in CutterPoint.model_fields)
    for point in drawing.profile:
        rows.writerow(repr(math.degrees(value) if name == "wall_angle" else value * MM) for name, value in point)
    return stream.getvalue()
