from learnblock.robots.ebo import Robot

robot = Robot()

# Loops that take values apart.
points = {"corner": [200, 0], "home": [0, 0]}


def visit(points):
    for name, place in points.items():  # in the order of the list
        for i, mm in enumerate(place):
            print(f"{name} {i}: {mm}")
        robot.go_to(place[0], place[1])


# main
visit(points)
for x, y, text in [[1, 2, "a"], [3, 4, "b"]]:
    print(x + y, text)
for pair in {"a": {"b": 1}}.items():
    print(pair[1]["b"], len(list(points.items())))
for name, place in list(points.items()):
    points.pop(name)
