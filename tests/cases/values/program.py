from learnblock.robots.ebo import Robot

robot = Robot()

# Values that depend on a condition.
x = 3
size = "large" if x > 5 else "middle" if x > 2 else "small"
y = (1 if x == 3 else 2) * 10
z = [x if x else y, not x if y or z else -x][0 if x > y else 1]

# Text with values in it.
told = f"x is {x}, {size}; '{y + 1}' {{braces}} ñ\n"
empty = f"{x}{y}{z}!" + f"" + f"it's {size}"
listed = f"{'-'.join(size.split('a'))} {[x, 'b'][0]} {told if x else told.real} {x != y}"


def nearer(a, b):
    return a if a < b else b


# main
if x if y else z:
    robot.turn(nearer(90, x) if robot.is_front_obstacle() else -90)
robot.wait_until(lambda: x if y else robot.is_any_tag())
for _ in range(3 if x else 4):
    print(f"{size}: {nearer(b=2, a=x)} of {len(told)}", f"{robot.is_front_obstacle()}")
for i in range(1 if x else 2, (10 if y else 5) + 1):
    print(nearer(a=i if i > 3 else 3, b=7))
