# learnblock robots test: the test of a real robot's devices.

# Questions to the person who watches; the answer is yes or no.
testing-ask-room = The robot will drive forward for one second, drive back, and turn. Is there enough room around it?
testing-ask-driven = Did it drive 5 cm forward and back, then turn right and back?
testing-ask-joint = Is the joint slightly above the middle (10°)?
testing-ask-joy = Does it look happy?
testing-ask-light = Is this light on (red, if it can change colour)?
testing-ask-beep = Did it beep?

# The result for a device, in the last column of a table.
# $reading is a value as Python writes it.
testing-reading = { $reading }
testing-picture = picture of { $width } × { $height } pixels
# Forward, left and up.
testing-acceleration = x { $x }, y { $y }, z { $z } m/s²
testing-drives = drives; no odometry
testing-drives-by-odometry = drives; odometry: { $distance } mm, { $angle }°
testing-angle = moves; reads { $angle }°
testing-no-angle = moves; its angle can't be read
testing-shows-joy = shows joy
testing-lights = lights up
testing-beeps = beeps
testing-no-tones = can't play tones
testing-not-driven = not driven
testing-not-seen = not seen
testing-no-picture = No picture arrived within 2 seconds.
testing-moved-otherwise = It did not move as described. In the robot settings, check the ports of its motors, and whether a motor needs the minus sign because it turns the other way.
