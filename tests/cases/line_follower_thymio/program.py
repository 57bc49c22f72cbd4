from learnblock.robots.ebo import Robot

robot = Robot()

# main
robot.look_floor()
while True:
    if robot.is_center_ground_line():
        robot.expressJoy()
        robot.move_straight()
    elif robot.is_left_ground_line():
        robot.expressJoy()
        robot.turn_left()
    elif robot.is_right_ground_line():
        robot.expressJoy()
        robot.turn_right()
    else:
        robot.expressSadness()
        robot.slow_down()
