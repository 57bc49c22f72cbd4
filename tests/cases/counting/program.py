from learnblock.robots.ebo import Robot

robot = Robot()

n = 5
for i in range(10):
    print(i)
for i in range(n + 1):
    print(i)
for i in range(1, n):
    print(i)
for i in range(1, n + 1 + 1):
    print(i)
for i in range(0):
    print(i)
for i in range(10, 0, -1):
    print(i)
for i in range(n, -1, -1):
    print(i)
for i in range(n, n - 3 - 1, -2):
    print(i)
for i in range(1, 10 + (1 if n > 0 else -1), n):
    print(i)
for i in range(1, 11, 2):
    for _ in range(n + 1):
        print(i)
