from learnblock.robots.ebo import Robot

robot = Robot()


# A house in colours, and a word about it.
def side(length, color):
    robot.set_pen_color(color)
    robot.drive_distance(length)


# main
robot.clear_drawing()
robot.set_pen_width(10)
robot.pen_down()
for color in ["red", "#ff8800"]:
    side(200, color)
    robot.turn_90_right()
robot.pen_up()
robot.show_text(f"{2} sides")
robot.show_number(200 / 3)
robot.clear_screen()
