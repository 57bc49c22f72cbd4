"""Positions in a frame."""

#: (column, row) in pixels; columns grow to the right, rows downwards.
Point = tuple[float, float]
