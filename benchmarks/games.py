"""A game with 30 things that move: the speed of its world, alone and with a program."""

import tempfile
from pathlib import Path
from time import perf_counter

from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.inline import InlineWorker
from learnblock.simulator import World, load_world

#: Times real time, at least.
AIM = 20
THINGS = 30
SECONDS = 60.0
PROGRAM = """\
main:
    forever:
        function.drive_distance(200)
        function.turn(90)
        if function.collected("anything"):
            function.change_score(1)
        end
    end
end
"""


def described(table: str, extra: str) -> str:
    """A world with so many things of one kind, half of them at random."""
    things = [
        f"[[{table}]]\n{extra}\nx = {-1300 + 90 * n}\ny = {600 if n % 2 else -600}\n"
        + ("wander = 300\n" if n % 2 else f"path = [[{-1300 + 90 * n}, -300]]\n")
        for n in range(THINGS)
    ]
    return "[floor]\nsize = [3200, 2400]\n[game]\nlives = 99\n" + "".join(things)


def alone(world: Path) -> float:
    """How many times as fast as real time the world runs without a program."""
    simulated = World(load_world(world), 0)
    simulated.game.join("robot", 0.0)
    began = perf_counter()
    while simulated.time < SECONDS:
        simulated.step()
    return SECONDS / (perf_counter() - began)


def played(world: Path, program: Path) -> tuple[float, str]:
    """The same with a robot and its program, and the hash of the trace."""
    source, entry = running.read(program), robots.find("sim-ebo")
    job = Job(running.program(source, entry), entry, Options(world=str(world), seconds=SECONDS))
    began = perf_counter()
    report = ProgramRun(job, worker=InlineWorker).run()
    return SECONDS / (perf_counter() - began), str(report.trace_sha256)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "game.bt"
        program.write_text(PROGRAM)
        for table, extra in (("mover", ""), ("collectable", 'kind = "bug"\nlives = -1')):
            world = Path(folder) / f"{table}.toml"
            world.write_text(described(table, extra))
            factor, digest = played(world, program)
            verdict = "met" if factor >= AIM else "missed"
            print(f"{THINGS} x {table}: world alone {alone(world):.0f} times real time")
            print(f"  with a program {factor:.0f} (aim {AIM}: {verdict}), {digest[:16]}")


if __name__ == "__main__":
    main()
