"""Measure the cost of driving an EV3 by each kind of connection, to an emulated brick.

Run it with ``python benchmarks/robots_ev3.py``. A control cycle is a command to the wheels and the
state of all sensors in its reply. It is compared with the same exchange without our code: the same
bytes on a bare socket, or the same call of bare rpyc.
"""

import socket
from collections.abc import Callable
from contextlib import closing
from time import perf_counter
from typing import Any

import rpyc

from learnblock.devices import Gyroscope
from learnblock.emulators import emulate
from learnblock.emulators.ev3 import AGENT
from learnblock.robots import connect
from learnblock.robots.ev3 import direct, lines
from learnblock.robots.ev3.brick import Drive
from learnblock.robots.ev3.rpyc_link import BEGIN
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.ev3.wires import UNLOCK
from learnblock.robots.wheel_counts import motor_speeds

#: Short and many, because the machine is also doing other work.
ROUNDS, CYCLES = 100, 100
#: The command that `move_straight(1)` sends.
DRIVE = Drive(*motor_speeds(1, 0, 30, 120))
#: The allowed extra cost over the bare connection: this fraction, or so many microseconds.
PART, LITTLE = 0.05, 20.0


def cost(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Return the microseconds of one call in the fastest round."""
    best = float("inf")
    for _ in range(rounds):
        began = perf_counter()
        for _ in range(CYCLES):
            work()
        best = min(best, perf_counter() - began)
    return best / CYCLES * 1e6


def bare_agent(settings: Any) -> float:
    """Send lines over a socket."""
    chosen = Settings(**settings)
    with socket.create_connection((chosen.address, chosen.agent_port)) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        heard = connection.makefile("rb")
        nonce = lines.greeting(heard.readline()).nonce
        connection.sendall(lines.introduction(chosen, nonce) + b"\n")
        heard.readline()
        word = lines.spoken(DRIVE) + b"\n"

        def cycle() -> None:
            connection.sendall(word)
            heard.readline()

        return cost(cycle)


def bare_rpyc(settings: Any) -> float:
    """Call the equivalent function on the brick."""
    with classic(settings) as connection:
        connection.execute(AGENT.read_text() + BEGIN)
        introduction = lines.introduction(Settings(**settings), "").decode()
        connection.eval(f"begin({introduction!r})")
        answer, word = connection.namespace["answer"], lines.spoken(DRIVE).decode()
        figure = cost(lambda: answer(word))
        connection.eval("end()")
    return figure


def papers_rpyc(settings: Any) -> float:
    """Drive like the paper's client: python-ev3dev2's motors from here, speeds created once."""
    with classic(settings) as connection:
        motors = connection.modules["ev3dev2.motor"]
        speed, gyroscope = motors.SpeedDPS(10), connection.modules["ev3dev2.sensor.lego"].GyroSensor
        left, right, gyroscope = motors.LargeMotor("outB"), motors.LargeMotor("outD"), gyroscope()

        def cycle() -> None:
            left.on(speed)
            right.on(speed)
            _ = left.position, right.position, gyroscope.angle

        figure = cost(cycle, 7)
        left.off()
        right.off()
    return figure


def classic(settings: Any) -> Any:
    """Connect with rpyc's defaults."""
    return closing(rpyc.classic.connect(settings["address"], settings["rpyc_port"]))


def bare_direct(settings: Any) -> float:
    """Send direct commands over a socket."""
    chosen = Settings(**settings)
    orders = direct.turn(1, 2, 300) + direct.turn(3, 2, 300)
    queries = [direct.turned(1), direct.turned(3)]
    queries += [direct.reading(port, 0) for port in range(4)]
    command = direct.command(1, orders, direct.Question(queries))
    with socket.create_connection((chosen.address, chosen.direct_port)) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall(UNLOCK)
        connection.recv(100)

        def cycle() -> None:
            connection.sendall(command)
            connection.recv(1024)

        return cost(cycle)


BARE = {"agent": bare_agent, "rpyc": bare_rpyc, "direct": bare_direct}


def measure(way: str) -> None:
    """Print the figures of one kind of connection."""
    with emulate("ev3", "empty", connection=way) as emulation:
        settings = dict(emulation.settings)
        bare = BARE[way](settings)
        paper = papers_rpyc(settings) if way == "rpyc" else None
        with connect("ev3", skills=("move_straight",), **settings) as robot:
            skill = cost(lambda: robot.move_straight(1))
            latest = cost(lambda: robot.read(Gyroscope, "Z_AXIS"))
    over = skill - bare
    met = over <= max(LITTLE, PART * bare)
    print(f"{way:<7} bare cycle {bare:8.1f} us  {1e6 / bare:8.0f}/s")
    print(
        f"        skill      {skill:8.1f} us  {1e6 / skill:8.0f}/s  {over:+.1f} us"
        f" ({over / bare:+.1%}): aim of {PART:.0%} or {LITTLE:g} us {'met' if met else 'MISSED'}"
    )
    if paper:
        print(f"        ev3dev2    {paper:8.1f} us  {1e6 / paper:8.0f}/s, driven from here")
    print(f"        reading    {latest:8.1f} us, polled beside the program")


def main() -> None:
    for way in BARE:
        measure(way)


if __name__ == "__main__":
    main()
