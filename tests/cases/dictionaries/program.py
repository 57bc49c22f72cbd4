from learnblock.robots.ebo import Robot

robot = Robot()

# Points for each colour that the robot finds.
points = {}
names = {"red": "rojo", "blue": "azul"}
nested = {"a": {1: [2, 3], "b": {}}, 2 + 1: "x" if points else None}
other = names


def count(colour):
    if colour in points:
        points[colour] += 1
    else:
        points[colour] = 1


# main
count("red")
points["blue"] = 5  # for the last one
nested["a"]["b"]["c"] = nested[3]
other["red"] += "!"
if "green" not in points and len(points) == 2:
    points.pop("blue")  # gone
    last = other.pop("red")
for colour in list(points.keys()):
    print(f"{names[colour]}: {points[colour]}", {"yes": 1}["yes"], other["blue"])
print(list(points.keys())[0], count(colour={"a": 1}["a"]))
points.clear()
