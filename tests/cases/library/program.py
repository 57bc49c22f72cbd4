import math
import random
import statistics

from learnblock.robots.ebo import Robot

robot = Robot()

xs = [3, 1, 2]
xs.append(4)
xs.insert(0, 9)
xs.remove(1)
xs.extend([5, 6])
last = xs.pop()
first = xs.pop(0)
xs.sort()
xs.reverse()
middle = xs[1 : len(xs) - 1]
where = xs.index(2) + xs.count(2)
other = xs.copy()
other.clear()
random.shuffle(xs)
print(len(xs), sum(xs), min(xs), max(1, 2), statistics.mean(xs))
print(statistics.median(xs), statistics.mode(xs), statistics.pstdev(xs))
x = math.sqrt(2) + abs(-2) + round(2.5, 1) + math.floor(2.5) + math.ceil(2.5)
x += math.exp(1) + math.log(2) + math.log10(100)
y = math.sin(math.radians(90)) + math.cos(math.radians(90)) + math.tan(math.radians(45))
y += math.degrees(math.asin(1)) + math.degrees(math.acos(0)) + math.degrees(math.atan(1)) + math.degrees(math.atan2(1, 2)) + math.pi * 2
z = random.randint(1, 6) + random.random() + min(max(x, 0), 100)
z += random.choice(xs)
text = "a".upper() + "B".lower() + "c d".title() + " e ".strip()
text = "abc".replace("b", "x")
parts = "a,b".split(",")
text += " ".join(parts) + str("abc".find("c")) + str(int("3")) + str(float("2.5"))
print((text + "!").upper(), parts[0:1][0], sorted(xs), sep=", ")
