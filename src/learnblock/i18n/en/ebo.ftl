# EBO's camera. $place is its address with its port.

ebo-camera-unreachable = Can't reach EBO's camera at { $place }. Start the camera on EBO, or set 'camera_port' to 0 in the robot settings to work without it.
ebo-camera-silent = EBO's camera at { $place } has sent no picture for { $seconds } seconds. Start the camera on EBO, or set 'camera_port' to 0 in the robot settings to work without it.
