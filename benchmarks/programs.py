"""Real-time factor of worlds whose robots run programs in separate processes, at 20 Hz."""

import os
from contextlib import nullcontext
from time import perf_counter

from learnblock.robots.sim_ebo import Robot
from learnblock.runtime.host import Host
from learnblock.runtime.process import one_processor
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Trace

STEERING = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()

while True:
    if robot.is_front_obstacle(150):
        robot.turn_right()
    else:
        robot.move_straight()
    robot.sleep(0.05)
"""
LOOKING = STEERING.replace("is_front_obstacle(150)", "is_any_tag()")
#: Program, robots, seconds of the world, and the target factor.
CASES = (
    ("1 robot", STEERING, 1, 200, 200),
    ("10 robots", STEERING, 10, 20, 30),
    ("30 robots", STEERING, 30, 6, 10),
    ("1 camera", LOOKING, 1, 40, 20),
)


def factor(python: str, count: int, seconds: float) -> float:
    """Return the seconds of the world for one second of real time, once all programs run."""
    simulation = Robot.make_simulation(world="tags")
    trace = Trace()
    started = 0.0

    def make_run(index: int) -> Run:
        program = Program("steering.py", python, python)

        def make_robot(*_program: object) -> Robot:
            nonlocal started
            # Measuring starts with the last program, when all processes run.
            started = perf_counter()
            return Robot(simulation=simulation, name=f"robot {index}")

        return Run(program, make_robot, lambda client: record(client, program.identity, trace))

    with one_processor() if count == 1 else nullcontext():
        Host(*(make_run(index) for index in range(count)), seconds=seconds).run()
    return seconds / (perf_counter() - started)


def main() -> None:
    print(f"{os.cpu_count()} processors; times real time")
    for name, python, count, seconds, aim in CASES:
        print(f"{name:<10} {factor(python, count, seconds):7.1f}  (aim {aim})")


if __name__ == "__main__":
    main()
