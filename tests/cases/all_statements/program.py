# Every statement of the language.
from learnblock.robots.ebo import Robot

robot = Robot()

total = 0
values = [1, 2.5, -3, "four", 'fi"ve', True, None, []]


def area(width, height):
    global total
    total += 1
    if width == height:
        return width**2
    return width * height


def greet():
    print("hello")


# main
for _ in range(3):
    total += area(2, height=3)
for value in values:
    if value == None:
        continue
    print(value)
for i in range(1, 11):
    values[0] = i
    while not total >= 10 and (i < 5 or 0 < i <= 7):
        total -= -i
        total *= 2
        total /= 3
        total //= 2
        total %= 7
        total **= 2
        break
if "a" in "abc" and 3 not in values:
    pass
elif values[-1][0] != 1:
    robot.move_straight(advSpeed=80)
else:
    robot.turn(90)
if robot.elapsedTime(60):
    greet()
