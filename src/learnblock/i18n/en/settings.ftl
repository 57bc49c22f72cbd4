# Settings of robots and of camera recognition, on the page and in settings.toml.

# $robot is a simulated robot.
settings-simulated = The robot '{ $robot }' is simulated, so it has no settings.
settings-agree-first = Read the text about emotions on real cameras and agree to it first.
settings-device = '{ $value }' is not a device. On the page, enter a device such as /dev/ttyACM0 or COM3.
settings-video = There is no video '{ $name }' in { $folder }. Put the video in this folder first.
