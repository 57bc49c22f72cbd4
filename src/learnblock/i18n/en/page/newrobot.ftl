# The dialog that creates a robot.

page-newrobot-menu = New robot…
page-newrobot-title = New robot
page-newrobot-help = LearnBlock creates a robot from its description: a driver with functions for you to write, a simulated twin that drives right away, and a test.
page-newrobot-name = Name (lowercase letters, digits and -)
page-newrobot-description = Description (TOML)
page-newrobot-file = From a file…
page-newrobot-make = Create robot
page-newrobot-large = { $name } is too large for a description.
page-newrobot-line = Line { $line }
page-newrobot-made = { $name } and its twin sim-{ $name } are ready. These files are yours:
page-newrobot-next = In the first file, each unfinished function says what it must do.
page-newrobot-use = Use the twin
