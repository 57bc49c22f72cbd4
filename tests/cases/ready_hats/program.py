from learnblock.robots.ebo import Robot

robot = Robot()


@robot.when(lambda: robot.is_key_pressed("up"))
def key_pressed():
    robot.drive_distance(30)


@robot.when(lambda: robot.is_key_pressed())
def key_pressed2():
    robot.stop_bot()


# The name is free.
@robot.when(lambda: robot.is_bumped())
def ouch():  # a hat, too
    robot.turn_back()


@robot.when(lambda: robot.is_front_obstacle(150))
def obstacle_near():
    robot.turn(90)


@robot.when(lambda: robot.is_front_obstacle(threshold=2 * 75))
def near2():
    pass


@robot.when(lambda: robot.received("go"))
def message_received():
    print(ouch.time)


@robot.when(lambda: not robot.is_bumped())
def no_hat():
    pass


robot.run()
