"""The motors of an emulated brick."""

#: The motor ports of the left and right wheels.
LEFT, RIGHT = "B", "D"
#: Degrees/s of a large motor at full speed.
FASTEST = 1050
