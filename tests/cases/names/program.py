import math
import random

from learnblock.robots.ebo import Robot

robot = Robot()

class_ = 1
class__ = 2
lambda_ = class_ + class__
random_ = random.randint(1, 6)
math_ = math.sqrt(random_)
robot_ = math_
range_ = [robot_]
print_ = len(range_)
time_ = 0
__ = time_
___ = __
repeat = 3
to = 1
step = 2
from_ = 3
ñandú = 4
list_ = None


def append(xs, class_):
    global list_
    list_ = [xs, class_]
    return list_


def len__(x):
    global lambda_
    x = 1
    for time_ in range(from_, to + (1 if step > 0 else -1), step):
        lambda_ = time_ + x
    return x


# main
append(range_, class_=1)
len__(2)
for _ in range(repeat):
    print(list_)
for _ in range(repeat):
    robot.import_(from_=1)
