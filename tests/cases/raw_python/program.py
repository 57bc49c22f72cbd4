from learnblock.robots.ebo import Robot

robot = Robot()

data = {"a", "b"}
# python
import json

def shout(text):
    """Say it
loudly."""
    return json.dumps(text)   +  '!'  # kept as it stands
# end
names = [name for name in data] + ["``"]

# main
while data.get("a") or not (lambda: 0):
    # python
    with open("log") as log:
        x = """
not indented
"""
    # # end
    # end
    # python
    y = 1
    # end
    x = (data @ data) * 2
    break
