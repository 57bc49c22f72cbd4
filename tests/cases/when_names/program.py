from learnblock.robots.ebo import Robot

robot = Robot()

seen = 0
tired_when = 0


@robot.when_start
def start():
    global seen
    class_.activate()
    seen += 1


# A name may serve a variable and a when.
@robot.when(lambda: robot.is_any_tag() and seen_when.time < 5)
def seen_when():
    global seen
    seen = seen + class_.time
    if tired_when_when.active:
        class_.deactivate()


@robot.when(lambda: robot.elapsedTime(60))
def tired_when_when():
    global tired_when
    tired_when = seen_when.active


@robot.when
def class_():
    robot.stop_bot()


# main
print(seen)

robot.run()
