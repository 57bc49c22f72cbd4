# What the page cannot do with the robot it watches.

monitor-program-running = A program is running. Stop it first.
monitor-drive-real = Only a simulated robot can be driven by hand. Choose one from the list of robots.
monitor-place-real = Only a simulated robot can be placed by hand. Pick up the real one and put it down yourself.
monitor-handle-real = Only a simulated robot can be shaken and tilted here. Take the real one in your hand.
