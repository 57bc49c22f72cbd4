from learnblock.robots.ebo import Robot

robot = Robot()

# main
robot.look_floor()
while True:
    if robot.is_center_black_line():
        robot.expressJoy()
        robot.move_straight()
    elif robot.is_left_black_line():
        robot.expressJoy()
        robot.move_left()
    elif robot.is_right_black_line():
        robot.expressJoy()
        robot.move_right()
    else:
        robot.expressSadness()
        robot.slow_down()
