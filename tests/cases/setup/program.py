# Follows a line.
from dance import *  # ours
from songs.slow import *
import math

from learnblock.robots.ebo import Robot

# the world
robot = Robot(world="line", seed=3)  # where it lives

waltz(3)
x = math.sqrt(2)
