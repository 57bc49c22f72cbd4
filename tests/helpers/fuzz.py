"""Fuzz everything that reads user input; only our own errors may be raised.

    uv run python tests/helpers/fuzz.py --seconds 600

It mutates the examples, the shipped worlds, robots and block configurations, and the malformed
files of the tests: characters, lines and tokens are dropped, doubled, swapped or taken from others.
"""

import argparse
import random
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import carried_files
import coppeliasim_answers
import cozmo_wires
import custom_block_files as block_files
import ev3_wires
import ice_wires
import library_files
import log_files
import old_projects
import set_files
import thymio_wires
from learnblock import language
from learnblock.blocks import builtin, load_configurations
from learnblock.blocks.schema import writing
from learnblock.errors import LearnBlockError, SettingsError
from learnblock.new.client import client_source
from learnblock.new.robot_plan import read_plan
from learnblock.perception.sources import TABLE
from learnblock.simulator import World, load_robot, load_world
from learnblock.storage.toml_source import read
from new_robots import EVERYTHING, guide
from places import ROOT, TESTS
from trees import has_distinct_whens

PACKAGE = ROOT / "src" / "learnblock"
#: Texts that caused errors in readers before.
NASTY = (
    "\0", "\ufeff", "\r", "\f", "\u2028", "\ud800", "'''", '"', "`", "#", "(" * 150, "[" * 300, ")",
    "end\n", "main:\n", "python:\n", "when x:\n", "if a:\n" * 120, "not " * 500, "-" * 500, "1e999",
    "9" * 5000, "0x", "nan", "inf", "-1", "= ", "== ", "{" * 200, "}", "[[robot]]\n", "a.b.c = 1\n",
    "true", "null", "\\u0000", "\\", "\t", "function.", "state_", "time_", "lambda: 0", "**" * 50,
    "é", "名", "🤖", "x" * 3000, "\n" * 100, "def f(x):\n    return x\n", "import os\n",
    "from x import *\n",
)  # fmt: skip

SETTINGS = (
    '[perception]\nemotions_on_cameras = true\napriltag = "localhost:25000"\nwebcam = 0\n',
    '[perception]\nlayout = "rows"\npatience = 2.5\nvideo = "a.mp4"\nwebcam = "none"\n[page]\n',
)


@dataclass(frozen=True)
class Target:
    """A reader of texts, and its initial texts."""

    name: str
    read: Callable[[str], object]
    corpus: tuple[str, ...]


def targets(folder: Path) -> tuple[Target, ...]:
    """Return every reader; those of files write each text into `folder`."""
    block_text = texts(ROOT / "examples", "*.bt") + texts(TESTS / "cases", "**/*.bt")
    python = tuple(
        language.to_python(language.parse(text)).text for text in texts(ROOT / "examples", "*.bt")
    )
    return (
        Target("Block-Text", read_block_text, block_text),
        Target("Python", read_python, (*python, *texts(PACKAGE / "language", "*.py")[:4])),
        Target(
            "world",
            lambda text: read_world(folder, text),
            texts(PACKAGE / "simulator" / "worlds", "*.toml")
            + texts(TESTS / "malformed", "**/*.toml"),
        ),
        Target(
            "robot description",
            lambda text: load_robot(written(folder / "robot.toml", text)),
            texts(PACKAGE / "simulator" / "robots", "*.toml"),
        ),
        Target("new robot", lambda text: new_robot(folder, text), (guide(), EVERYTHING)),
        Target(
            "block configuration",
            load_configurations,
            tuple(writing.written([block]) for block in builtin().values())
            + texts(TESTS / "unit" / "blocks" / "schema" / "malformed", "*.json"),
        ),
        Target(
            "set of blocks",
            lambda text: set_files.read_set(written(folder / "set.toml", text)),
            texts(set_files.SETS, "*.toml"),
        ),
        Target("original project", old_projects.read_text, old_projects.texts()),
        Target("names of tags", set_files.read_tags, set_files.DICTIONARIES),
        Target("library's manifest", library_files.read_manifest, (library_files.MANIFEST,)),
        Target("library's functions", library_files.read_functions, (library_files.FUNCTIONS,)),
        Target("library's Python", library_files.read_python, (library_files.PYTHON,)),
        Target("library in one file", library_files.read_archive, library_files.archives()),
        Target("world in one file", carried_files.read_world, carried_files.world_texts()),
        Target("carrying project", carried_files.read_project, carried_files.project_texts()),
        Target("source of blocks", block_files.read_source, (block_files.SOURCE,)),
        Target("chosen for blocks", block_files.read_configuration, (block_files.WORDS,)),
        Target("exported block", block_files.read_package, (block_files.PACKAGE,)),
        Target("run's log", log_files.read_log, log_files.texts()),
        Target("settings", lambda text: read_settings(folder, text), SETTINGS),
        Target("CoppeliaSim's answers", coppeliasim_answers.read, coppeliasim_answers.texts()),
        Target("Cozmo's frames", cozmo_wires.read_frame, cozmo_wires.frame_texts()),
        Target("Cozmo's pictures", cozmo_wires.read_picture, cozmo_wires.picture_texts()),
        Target("Cozmo's screen", cozmo_wires.read_screen, cozmo_wires.screen_texts()),
        Target("EV3's agent", ev3_wires.read_agent, ev3_wires.agent_texts()),
        Target("EV3's firmware", ev3_wires.read_firmware, ev3_wires.firmware_texts()),
        Target("Thymio's messages", thymio_wires.read_robot, thymio_wires.robot_texts()),
        Target("Thymio Suite's", thymio_wires.read_suite, thymio_wires.suite_texts()),
        Target("Ice's requests", ice_wires.read_asked, tuple(ice_wires.request_texts())),
        Target("Ice's replies", ice_wires.read_answer, tuple(ice_wires.reply_texts())),
    )


def texts(folder: Path, pattern: str) -> tuple[str, ...]:
    """Return the texts of a folder's files."""
    return tuple(
        path.read_text(encoding="utf-8", errors="replace") for path in sorted(folder.glob(pattern))
    )


def read_block_text(text: str) -> None:
    """Perform every operation on a program in Block-Text."""
    tree, _ = language.recover(text)
    diagnostics = language.check(tree, builtin(), frozenset({"Base"}))
    tree = language.parse(text)
    canonical = language.format(tree)
    if language.format(language.parse(canonical)) != canonical:
        raise AssertionError("the canonical form is not stable")
    python = language.to_python(tree).text
    if any(diagnostic.code in {"invalid-python", "too-deep"} for diagnostic in diagnostics):
        # The check refuses it: invalid raw Python may end where another part begins.
        return
    back = language.from_python(python)
    if language.to_python(back).text != python:
        raise AssertionError("Python does not come back from its tree")
    # Raw Python that Block-Text can express comes back as Block-Text, and the rest unchanged. Two
    # events of one name, which the check refuses, stay Python.
    could_change = "`" in canonical or "python:" in canonical or not has_distinct_whens(tree)
    if back != tree and not could_change:
        raise AssertionError("the tree does not come back from Python")


def read_python(text: str) -> None:
    """Perform every operation on a program in Python."""
    tree = language.from_python(text)
    if language.to_python(tree, None).text != text:
        raise AssertionError("Python does not come back byte for byte")
    language.check(tree, builtin())
    language.parse(language.format(tree))


def new_robot(folder: Path, text: str) -> object:
    """Check that the client of a description is always valid Python."""
    plan = read_plan(written(folder / "plan.toml", text))
    return compile(client_source(plan, plan.title), "client.py", "exec")


def read_world(folder: Path, text: str) -> None:
    """Load a world and advance it briefly."""
    world = World(load_world(written(folder / "world.toml", text)))
    world.step()
    if world.game.has_things:
        world.add_robot(load_robot("ebo"))
        world.game.join("robot", world.time)
        for _ in range(10):
            world.step()


def read_settings(folder: Path, text: str) -> None:
    """Read a user's settings of camera recognition."""
    file = written(folder / "settings.toml", text)
    read(file, TABLE._file_kind(), SettingsError, lambda _: ())


def written(path: Path, text: str) -> Path:
    """Write a text with any content."""
    path.write_text(text, encoding="utf-8", errors="surrogatepass", newline="")
    return path


def mutated(text: str, corpus: tuple[str, ...], chance: random.Random) -> str:
    """Damage a text one to six times."""
    for _ in range(chance.randint(1, 6)):
        start = chance.randint(0, len(text))
        end = min(len(text), start + chance.choice((0, 1, 1, 5, 40)))
        other = chance.choice(corpus)
        begin = chance.randint(0, len(other))
        letter = chr(chance.randint(0, 0x2FF))
        doubled = text[start:end] * 2
        piece = chance.choice(
            ("", chance.choice(NASTY), other[begin : begin + 30], doubled, letter)
        )
        text = text[:start] + piece + text[end:]
    return text[:100_000]


def inputs(target: Target, chance: random.Random) -> Iterator[str]:
    """Yield an endless series of texts: first the corpus unchanged, then mutations."""
    yield from target.corpus
    while True:
        yield mutated(chance.choice(target.corpus), target.corpus, chance)


def attempt(target: Target, text: str, counts: Counter[str]) -> str | None:
    """Read one text; return the traceback of an error that is not ours, or None."""
    try:
        target.read(text)
    except LearnBlockError:
        counts[f"{target.name}: refused"] += 1
    except Exception:  # noqa: BLE001 - finding these is what a fuzzer is for
        return traceback.format_exc()
    else:
        counts[f"{target.name}: accepted"] += 1
    return None


def fuzz(seed: int, seconds: float, most: int | None = None) -> tuple[Counter[str], list[str]]:
    """Fuzz the targets in turns; return the counts, and the failures with their inputs."""
    chance = random.Random(seed)  # noqa: S311 - repeatable, not secret
    counts: Counter[str] = Counter()
    failures: list[str] = []
    deadline = time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        sources = [(target, inputs(target, chance)) for target in targets(Path(folder))]
        while time.monotonic() < deadline and (most is None or counts.total() < most):
            for target, source in sources:
                text = next(source)
                if failure := attempt(target, text, counts):
                    failures.append(f"{target.name}: {text!r}\n{failure}")
    return counts, failures


def main() -> None:
    """Run for the given time and print the counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    counts, failures = fuzz(options.seed, options.seconds)
    for name, count in sorted(counts.items()):
        print(f"{name:<32} {count}")  # noqa: T201 - its report
    for failure in failures[:20]:
        print(failure[-3000:])  # noqa: T201 - its report
    print(f"{counts.total()} inputs, {len(failures)} failures")  # noqa: T201 - its report
    raise SystemExit(bool(failures))


if __name__ == "__main__":
    main()
