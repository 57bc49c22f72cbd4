from learnblock.robots.ebo import Robot

robot = Robot()

# Drive to four walls.
forever = 0


def approach(until):
    robot.move_straight()
    robot.wait_until(lambda: robot.is_front_obstacle() or robot.elapsedTime(until))  # the wall
    robot.stop_bot()


# main
# The loop ends itself.
while True:  # until the fourth wall
    approach(60)
    forever += 1
    while True:
        robot.turn_right()
        robot.wait_until(lambda: not robot.is_front_obstacle())
        break
    if forever == 4:
        break
