# The link to a real robot, above the world.

page-link-disconnected = Not connected
page-link-connected = Connected
page-link-weak = Weak connection
page-link-lost = Connection lost
# $volts has one decimal.
page-link-battery = battery { $volts } V
# The tooltip; $percent of the robot's messages arrive.
page-link-quality = { $percent }% of the robot's messages arrive.

# Read aloud when the link changes.
page-link-weak-said = The connection to the robot is weak.
page-link-lost-said = The connection to the robot is lost. Is it on and within range?

# The robot in words, where its position is not known; $robot is its title.
page-link-robot-unlocated = { $robot } on a plain floor. Its position is unknown
# The world in words, under a real robot.
page-link-plain-floor = A plain floor with the robot.
# Shown in place of the joystick.
page-link-drive-simulated = Only a simulated robot can be driven by hand.
# Joystick and arrow keys place simulated robots only.
page-link-place-simulated = Only a simulated robot can be placed. Pick up the real one and put it down yourself.
