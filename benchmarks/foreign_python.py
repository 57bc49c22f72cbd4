"""Print how much of Python that people wrote elsewhere is blocks, and what is left grey.

Run it with ``python benchmarks/foreign_python.py`` for the standard library's ``turtledemo``, or
name folders with Python files. ``--fetch pybricks`` also takes the source distribution of a
package from the index, into a temporary folder. A file that takes more than ``--limit`` seconds
of processor time counts as one that does not come back, and is listed.
"""

import argparse
import signal
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile
from collections import Counter
from pathlib import Path
from types import FrameType

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from python_scores import TURTLEDEMO, Scores, scores_of

#: The most kinds of grey parts that are named.
NAMED = 20
#: Seconds that the index and the package's own build may take.
FETCHING = 180
#: Seconds between two lines about the progress.
PROGRESS = 10


def fetched(package: str, folder: Path) -> Path:
    """The unpacked source distribution of a package."""
    target = folder / package
    # The build tools may be wheels: `:all:` would compile them from source, too.
    options = ["--quiet", "--no-deps", f"--no-binary={package}", "--dest", str(target)]
    command = ["uv", "tool", "run", "pip", "download", *options, package]
    subprocess.run(command, check=True, timeout=FETCHING)
    for archive in list(target.iterdir()):
        if archive.suffix == ".zip":
            with zipfile.ZipFile(archive) as packed:
                packed.extractall(target)  # noqa: S202 - an archive of the index
        else:
            with tarfile.open(archive) as packed:
                packed.extractall(target, filter="data")
    return target


def corpus_scores(folder: Path, limit: int) -> Scores:
    """The scores of the files in a folder, with progress on the standard error."""
    paths = sorted(folder.rglob("*.py"))
    found = Scores()
    told = time.monotonic()
    for done, path in enumerate(paths):
        if time.monotonic() > told + PROGRESS:
            told = time.monotonic()
            print(f"{folder.name}: {done} of {len(paths)} files", file=sys.stderr, flush=True)
        signal.setitimer(signal.ITIMER_PROF, limit)
        try:
            found += scores_of([path])
        except _TooLongError:
            found += Scores(files=1, left=Counter({f"{path.name}: longer than {limit} s": 1}))
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
    return found


class _TooLongError(Exception):
    """A file takes too long."""


def _end(_signal: int, _frame: FrameType | None) -> None:
    raise _TooLongError


def report(name: str, scores: Scores) -> None:
    shares = f"{scores.in_blocks:>8.1f} %  {scores.sockets_in_blocks:>8.1f} %"
    files = f"{scores.ungrey:>6}  {scores.kept:>6}  {scores.same:>6}"
    print(f"{name:24}{scores.files:>6}{scores.statements:>12}  {shares}  {files}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path, help="folders with Python files")
    parser.add_argument("--fetch", action="append", default=[], metavar="PACKAGE")
    parser.add_argument(
        "--limit", type=int, default=20, help="seconds of processor time for each file"
    )
    given = parser.parse_args()
    signal.signal(signal.SIGPROF, _end)
    heads = "   files  statements    in blocks     sockets   whole    kept    same"
    print(f"{'':22}{heads}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        found: list[tuple[str, Scores]] = []
        folders = [*given.folders, *([] if given.folders or given.fetch else [TURTLEDEMO])]
        for path in [*folders, *given.fetch]:
            place = path if isinstance(path, Path) else fetched(path, Path(folder))
            found.append((place.name, corpus_scores(place, given.limit)))
            report(*found[-1])
    for name, scores in found:
        print(f"\n{name}: what is left")
        for kind, count in scores.left.most_common(NAMED):
            print(f"{count:>6}  {kind}")


if __name__ == "__main__":
    main()
