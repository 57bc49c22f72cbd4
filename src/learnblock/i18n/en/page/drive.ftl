# Driving the robot by hand.

page-drive-title = Manual control
page-drive-stick = Joystick
page-drive-keys = Drag the knob, or press the arrow keys or W, A, S and D.
page-drive-runs = A program is driving the robot. Stop it to drive manually.
