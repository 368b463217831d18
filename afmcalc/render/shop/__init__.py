"""Drawings for the shop in true millimetres: DXF, SVG and the profile of the wall as CSV."""
