"""How long links of projects are, and whether what they open runs as what was shared.

    python benchmarks/links.py [seconds of simulated time]

Every example and every solution of a lesson becomes a link, which is read in another home, without
the lessons' worlds. Both projects run, each in a process of its own, for 20 seconds at most: the
program has to be the same and the trace to have one hash. A project that is too large for a link is
named.
"""

import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import msgspec

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "helpers"))

from learnblock import robots, running  # noqa: E402 - after the path, for one order
from learnblock.language import format as formatted  # noqa: E402 - as above
from learnblock.language import from_python  # noqa: E402 - as above
from learnblock.lessons.opened import OpenLesson  # noqa: E402 - as above
from learnblock.lessons.reading import find_lesson, shipped  # noqa: E402 - as above
from learnblock.project.files.project import Project  # noqa: E402 - as above
from learnblock.project.files.project_file import encode  # noqa: E402 - as above
from learnblock.project.files.share_link import (  # noqa: E402 - as above
    LinkError,
    ProvedRun,
    SharedProject,
    link_of,
    read_link,
)
from learnblock.runtime.ending import How  # noqa: E402 - as above
from runs import EXAMPLES, TASKS, TWINS  # noqa: E402 - found through the line above

#: Any fingerprint: a link has one if its run has finished.
RUN = ProvedRun(16.4, How.FINISHED, "0.2.0", "7f3a91c2" * 8)
#: The characters of a hash; anything else is what went wrong.
HASH = 64


@dataclass(frozen=True)
class Opened:
    """A project that was shared, and what its link opened.

    Args:
        project: the project.
        link: its link; empty if it is too large for one.
        is_same: whether the program is the same.
        hashes: of the traces of both.
    """

    project: Project
    link: str
    is_same: bool = False
    hashes: tuple[str, str] = ("", "")


def examples() -> Iterator[Project]:
    """The examples, each on the first twin that is able to run it."""
    for name, (world, _) in sorted(TASKS.items()):
        source = running.read(EXAMPLES / name)
        robot = next(twin for twin in TWINS if not errors(source, twin))
        title = name.removesuffix(".bt").replace("/", "-")
        yield Project(title, source.text, robot=robot, world=world)


def errors(source: running.Source, twin: str) -> list[object]:
    found = running.check(source, robots.find(twin))
    return [one for one in found if one.severity == "error"]


def solutions() -> Iterator[Project]:
    """The solutions of the lessons that come with LearnBlock, in their worlds."""
    for name in shipped():
        lesson = find_lesson(name)
        for number in range(1, len(lesson.lesson.step) + 1):
            text = lesson.solution(number)
            if text and lesson.teacher:
                is_python = lesson.teacher.solutions[str(number)].endswith(".py")
                blocktext = formatted(from_python(text)) if is_python else text
                world, robot = lesson.world(number) or "", lesson.robots(number)[0]
                yield Project(f"{name}-{number}", blocktext, robot=robot, world=world)


def keep_worlds(lesson: OpenLesson, home: Path) -> None:
    """Put a lesson's own worlds into a home, as opening the lesson would."""
    for path, content in lesson.files.items():
        if path.startswith("worlds/"):
            file = home / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)


def opened(project: Project, homes: tuple[Path, Path], link: str, seconds: str) -> Opened:
    """Open a link in the second home, and run both projects."""
    other = read_link(link).project
    pair = [(homes[0], project), (homes[1], other)]
    hashes = [trace_of(one, home, seconds) for home, one in pair]
    is_same = project.blocktext == other.blocktext and project.robot == other.robot
    return Opened(project, link, is_same, (hashes[0], hashes[1]))


def trace_of(project: Project, home: Path, seconds: str) -> str:
    """Run a project in a home, and return the hash of its trace."""
    file = home / f"{project.name}.learnblock"
    file.write_bytes(encode(project))
    command = [sys.executable, "-m", "learnblock", "run", file, "--json", "--for", seconds]
    variables = {**os.environ, "LEARNBLOCK_HOME": str(home)}
    done = subprocess.run(
        command, env=variables, capture_output=True, stdin=subprocess.DEVNULL, check=False
    )
    try:
        return str(msgspec.json.decode(done.stdout)["trace_sha256"])
    except (msgspec.DecodeError, KeyError, TypeError):
        return f"no report: {done.stderr.decode()[-300:]}"


def shared(project: Project) -> Opened:
    """Make a link of a project."""
    try:
        return Opened(project, link_of(SharedProject(project, run=RUN)))
    except LinkError:
        return Opened(project, "")


def runs_the_same(one: Opened) -> bool:
    first, second = one.hashes
    return one.is_same and first == second and len(first) == HASH


def report(kind: str, results: list[Opened]) -> bool:
    """Print the figures; return whether all is well."""
    lengths = [len(one.link) for one in results if one.link]
    wrong = [one for one in results if not runs_the_same(one)]
    right = 100 * (len(results) - len(wrong)) / len(results)
    longest = max(results, key=lambda one: len(one.link)).project.name
    print(
        f"{kind}: {len(results)} projects; links of {statistics.median(lengths):.0f} characters "
        f"(median), at most {max(lengths)} ({longest}); {right:.0f} % open and run the same"
    )
    for one in wrong:
        print(f"    {one.project.name}: {'too large' if not one.link else one.hashes}")
    return not wrong


def main() -> None:
    seconds = sys.argv[1] if len(sys.argv) > 1 else "20"
    with tempfile.TemporaryDirectory() as folder:
        homes = Path(folder, "shares"), Path(folder, "opens")
        for home in homes:
            home.mkdir()
        for name in shipped():
            keep_worlds(find_lesson(name), homes[0])
        well = [figures(kind, homes, seconds) for kind in ("examples", "solutions")]
    sys.exit(0 if all(well) else 1)


def figures(kind: str, homes: tuple[Path, Path], seconds: str) -> bool:
    """Share and open all projects of a kind."""
    os.environ["LEARNBLOCK_HOME"] = str(homes[0])
    links = [shared(one) for one in {"examples": examples, "solutions": solutions}[kind]()]
    os.environ["LEARNBLOCK_HOME"] = str(homes[1])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        again = [one for one in links if one.link]
        made = pool.map(lambda one: opened(one.project, homes, one.link, seconds), again)
        return report(kind, [*made, *(one for one in links if not one.link)])


if __name__ == "__main__":
    main()
