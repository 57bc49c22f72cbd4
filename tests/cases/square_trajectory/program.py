from learnblock.robots.ebo import Robot

robot = Robot()

times = None
angle = None

# main
times = 0
angle = 90
robot.reset_orientation()
while times < 4:
    robot.move_straight()
    robot.sleep(5)
    robot.stop_bot()
    robot.set_orientation(angle)
    times += 1
    angle += 90
