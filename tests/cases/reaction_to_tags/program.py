from learnblock.robots.ebo import Robot

robot = Robot()


@robot.when_start
def start():
    robot.expressNeutral()
    robot.look_front()
    maincontrol.activate()


@robot.when
def maincontrol():
    if approach_tag.active:
        if robot.is_tag(1):
            showJoy.activate()
        elif robot.is_tag(2):
            showSurprise.activate()
        else:
            showFear.activate()


@robot.when(lambda: not robot.is_any_tag())
def no_tag():
    robot.look_front()
    robot.turn_right()


@robot.when(lambda: robot.is_any_tag())
def approach_tag():
    if robot.tag_on_the_right():
        robot.move_right()
    elif robot.tag_on_the_left():
        robot.move_left()
    else:
        robot.move_straight()


@robot.when
def showJoy():
    if not approach_tag.active:
        robot.stop_bot()
        robot.expressJoy()
        robot.sleep(2)
        showJoy.deactivate()


@robot.when
def showSurprise():
    if not approach_tag.active:
        robot.stop_bot()
        robot.expressSurprise()
        robot.sleep(2)
        showSurprise.deactivate()


@robot.when
def showFear():
    if not approach_tag.active:
        robot.stop_bot()
        robot.expressFear()
        robot.sleep(2)
        showFear.deactivate()


robot.run()
