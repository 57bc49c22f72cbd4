"""The program that runs on a Thymio while LearnBlock drives it.

Only a program on the robot itself can use its LEDs and sounds, so one is uploaded. It waits for
our events, and acts as a watchdog: after `LIVES` ticks without a `DRIVE` event it stops the
motors.

There are two versions: assembly, which `thymiodirect` translates to the robot's bytecode, and
source text, which Thymio Suite compiles.
"""

from collections.abc import Mapping
from dataclasses import dataclass

#: Milliseconds of a tick of the watchdog.
TICK = 50
#: The number of ticks without a command after which the motors stop.
LIVES = 5


@dataclass(frozen=True, slots=True)
class Event:
    """An event sent to the robot's program, or by it.

    Args:
        number: identifies it in Aseba's protocol.
        name: identifies it in Thymio Suite.
        size: the number of its values.
    """

    number: int
    name: str
    size: int


#: Motor speeds, left and right, -500 to 500; must be repeated while the robot drives.
DRIVE = Event(0, "drive", 2)
#: Red, green and blue, 0 to 32.
TOP = Event(1, "top", 3)
LEFT = Event(2, "left", 3)
RIGHT = Event(3, "right", 3)
#: Hertz and sixtieths of a second.
TONE = Event(4, "tone", 2)
#: The number of one of the robot's sounds, or of one on its memory card.
SOUND = Event(5, "sound", 1)
PLAY = Event(6, "play", 1)
#: Sent by the robot: the program has started, with its token; a command was executed, with its
#: number.
READY = Event(7, "ready", 1)
DONE = Event(8, "done", 4)

COMMANDS = (DRIVE, TOP, LEFT, RIGHT, TONE, SOUND, PLAY)
EVENTS = (*COMMANDS, READY, DONE)

#: The robot's function for each command that calls one.
NATIVES: Mapping[Event, str] = {
    TOP: "leds.top",
    LEFT: "leds.bottom.left",
    RIGHT: "leds.bottom.right",
    TONE: "sound.freq",
    SOUND: "sound.system",
    PLAY: "sound.play",
}


def assembly(token: int) -> str:
    """The program for `thymiodirect.assembler`; its variables come after the robot's own.

    Args:
        token: sent when it starts, 0 to 2000, to distinguish it from another client's program.
    """
    vectors = "\n".join(f"    dc {event.number}, {event.name}" for event in COMMANDS)
    calls = "\n".join(_call(event, native) for event, native in NATIVES.items())
    return f"""
life: equ _userdata
done: equ _userdata+1
    dc end_of_vectors
    dc _ev.init, start
    dc _ev.timer0, tick
{vectors}
end_of_vectors:
start:
    push.s {TICK}
    store timer.period
    push.s {token}
    store done
    emit {READY.number}, done, {READY.size}
rest:
    push.s 0
    store motor.left.target
    push.s 0
    store motor.right.target
    push.s 0
    store life
    stop
tick:
    load life
    push.s 0
    jump.if.not gt, rest
    load life
    push.s 1
    sub
    store life
    stop
drive:
    load event.args
    store motor.left.target
    load event.args+1
    store motor.right.target
    push.s {LIVES}
    store life
    stop
{calls}
"""


def _call(event: Event, native: str) -> str:
    """Call a function of the robot with the values of an event, and report it.

    The arguments are the addresses of the values, the last one pushed first.
    """
    pushes = [f"    push event.args+{index}" for index in reversed(range(event.size))]
    copies = [
        f"    load event.args+{index}\n    store done+{index + 1}" for index in range(event.size)
    ]
    lines = [
        f"{event.name}:",
        *pushes,
        f"    callnat _nf.{native}",
        f"    push.s {event.number}",
        "    store done",
        *copies,
        f"    emit {DONE.number}, done, {DONE.size}",
        "    stop",
    ]
    return "\n".join(lines)


def source() -> str:
    """The same program in the robot's language, for Thymio Suite's compiler."""
    calls = "\n".join(_source_call(event, native) for event, native in NATIVES.items())
    return f"""
var life = 0
timer.period[0] = {TICK}
motor.left.target = 0
motor.right.target = 0

onevent {DRIVE.name}
motor.left.target = event.args[0]
motor.right.target = event.args[1]
life = {LIVES}

onevent timer0
if life > 0 then
    life = life - 1
else
    motor.left.target = 0
    motor.right.target = 0
end
{calls}"""


def _source_call(event: Event, native: str) -> str:
    arguments = ", ".join(f"event.args[{index}]" for index in range(event.size))
    return f"\nonevent {event.name}\ncall {native}({arguments})\n"
