# iRobot's education robots. $place is an address or a robot's id.

irobot-garbled = The device at { $place } does not behave like a robot of iRobot's. Check the address in the robot settings.
irobot-button = The button of the robot at { $place } was pressed, so the robot stopped and the program ended.
irobot-is-root = The robot at { $place } is a Root. Choose the robot 'root' for it.
irobot-is-create3 = The robot at { $place } is a Create 3. Choose the robot 'create3' for it.
irobot-marker-stuck = Root's marker did not move within three seconds. Take the marker out, and put it in so that it just does not touch the floor.
