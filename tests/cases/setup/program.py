# Follows a line.
from learnblock.libraries.dance import *  # ours
from learnblock.libraries.songs.slow import *
import math

from learnblock.robots.ebo import Robot

# the world
robot = Robot(world="line", seed=3)  # where it lives

waltz(3)
x = math.sqrt(2)
