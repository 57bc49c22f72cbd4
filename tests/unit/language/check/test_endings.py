"""What could end a loop or a wait: the check is silent where anything could."""

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, parse

ENDS = {
    "a sensor": "wait until function.is_front_obstacle()",
    "time": "while not elapsedTime(3):\n    pass\nend",
    "chance": "while random(1, 6) < 6:\n    pass\nend",
    "a typed answer": 'while input("?") != "stop":\n    pass\nend',
    "a message": 'wait until function.received("go")',
    "a key": 'wait until function.is_key_pressed("space")',
    "raw Python": "wait until `ready()`",
    "the loop sets it": "x = 1\nwhile x < 9:\n    x += 1\nend",
    "a loop inside sets it": (
        "x = 1\nwhile x < 9:\n    for x from 1 to 9:\n        pass\n    end\nend"
    ),
    "a function of the loop sets it": (
        "x = 1\ndef more():\n    x += 1\nend\nwhile x < 9:\n    more()\nend"
    ),
    "a function of a function sets it": (
        "x = 1\ndef a():\n    b()\nend\ndef b():\n    x += 1\nend\nwhile x < 9:\n    a()\nend"
    ),
    "the condition's function asks the robot": (
        "def near():\n    return function.is_front_obstacle()\nend\nwait until near()"
    ),
    "the condition's function counts": (
        "n = 0\ndef more():\n    n += 1\n    return n\nend\nwait until more() > 3"
    ),
    "break": "x = 1\nwhile x < 9:\n    if function.is_any_tag():\n        break\n    end\nend",
    "break by a sensor": ("forever:\n    if function.is_any_tag():\n        break\n    end\nend"),
    "break by a counter": (
        "n = 0\nforever:\n    n += 1\n    if n > 3:\n        break\n    end\nend"
    ),
    "one way out of two by a sensor": (
        "x = 1\nforever:\n    if x > 3:\n        break\n    end\n"
        "    if function.is_any_tag():\n        break\n    end\nend"
    ),
    "a list that a loop through it adds to and leaves": (
        "a = [1]\nfor x in a:\n    append(a, x)\n    if len(a) > 9:\n        break\n    end\nend"
    ),
    "return": "x = 1\ndef f():\n    while x < 9:\n        return\n    end\nend\nf()",
    "raw Python in the loop": "x = 1\nwhile x < 9:\n    python:\n        x = 10\n    end\nend",
    "items": "values = []\nwhile len(values) < 3:\n    append(values, 1)\nend",
    "items taken in the condition": "values = [1, 0]\nwhile pop(values) > 0:\n    pass\nend",
    "items of a list with two names": ("a = []\nb = a\nwhile len(a) < 3:\n    append(b, 1)\nend"),
    "items that a function adds": (
        "a = []\ndef add(values):\n    append(values, 1)\nend\nwhile len(a) < 3:\n    add(a)\nend"
    ),
    "an item that is set": "a = [1]\nwhile a[0] < 3:\n    a[0] = a[0] + 1\nend",
    "what the robot is told": (
        "function.set_move(80, 0)\nwhile function.is_moving_straight():\n"
        "    function.slow_down()\nend"
    ),
    "an event's own time": (
        "when go = function.is_any_tag():\n    while time_go < 3:\n        function.sleep(1)\n"
        "    end\nend"
    ),
    "the time of an event that was started": (
        "when start:\n    activate go\n    wait until time_go > 3\nend\nwhen go:\n    print(1)\nend"
    ),
    "the time of an event that may be active": (
        "when a = function.is_any_tag():\n    wait until time_b > 3\nend\n"
        "when b = function.is_front_obstacle():\n    print(1)\nend"
    ),
    "a state that the loop changes": (
        "when start:\n    activate go\n    while state_go:\n        deactivate go\n    end\nend\n"
        "when go:\n    print(1)\nend"
    ),
    "an endless loop of the only event": (
        "when go = function.is_any_tag():\n    forever:\n        function.turn(90)\n    end\nend"
    ),
    "an endless loop with a way out in an event": (
        "when a = function.is_any_tag():\n    forever:\n        if function.is_bumped():\n"
        "            return\n        end\n    end\nend\n"
        "when b = function.is_front_obstacle():\n    print(1)\nend"
    ),
    "an endless loop in a function that nothing calls": (
        "def f():\n    forever:\n        function.turn(90)\n    end\nend\n"
        "when b = function.is_front_obstacle():\n    print(1)\nend"
    ),
    "lines below a function that may return": (
        "def f():\n    if function.is_any_tag():\n        return\n    end\n"
        "    forever:\n        function.turn(90)\n    end\nend\nf()\nprint(1)"
    ),
}


@pytest.mark.parametrize("program", ENDS.values(), ids=ENDS)
def test_nothing_is_said_about_a_loop_that_something_could_end(program):
    found = check(parse(program + "\n"), builtin())
    flow = {"idle-loop", "idle-wait", "events-never-run", "unreachable"}
    assert [] == [str(one.message) for one in found if one.code in flow]
