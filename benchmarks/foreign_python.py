"""Print how much of Python that people wrote elsewhere is blocks, and what is left grey.

Run it with ``python benchmarks/foreign_python.py`` for the standard library's ``turtledemo``, or
name folders with Python files. ``--fetch pybricks-api`` also takes the source distribution of a
package from the index, into a temporary folder.
"""

import argparse
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from python_scores import TURTLEDEMO, Scores, scores_of

#: The most kinds of grey parts that are named.
NAMED = 20


def fetched(package: str, folder: Path) -> Path:
    """The unpacked source distribution of a package."""
    target = folder / package
    command = ["uv", "tool", "run", "pip", "download", "--quiet", "--no-deps", "--no-binary=:all:"]
    subprocess.run([*command, "--dest", str(target), package], check=True)
    for archive in list(target.iterdir()):
        if archive.suffix == ".zip":
            with zipfile.ZipFile(archive) as packed:
                packed.extractall(target)  # noqa: S202 - an archive of the index
        else:
            with tarfile.open(archive) as packed:
                packed.extractall(target, filter="data")
    return target


def report(name: str, scores: Scores) -> None:
    shares = f"{scores.in_blocks:>8.1f} %  {scores.sockets_in_blocks:>8.1f} %"
    files = f"{scores.ungrey:>6}  {scores.kept:>6}  {scores.same:>6}"
    print(f"{name:24}{scores.files:>6}{scores.statements:>12}  {shares}  {files}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path, help="folders with Python files")
    parser.add_argument("--fetch", action="append", default=[], metavar="PACKAGE")
    given = parser.parse_args()
    heads = "   files  statements    in blocks     sockets   whole    kept    same"
    print(f"{'':22}{heads}")
    with tempfile.TemporaryDirectory() as folder:
        folders = given.folders or [TURTLEDEMO]
        folders += [fetched(package, Path(folder)) for package in given.fetch]
        found = [scores_of(sorted(path.rglob("*.py"))) for path in folders]
    for path, scores in zip(folders, found, strict=True):
        report(path.name, scores)
    for path, scores in zip(folders, found, strict=True):
        print(f"\n{path.name}: what is left")
        for name, count in scores.left.most_common(NAMED):
            print(f"{count:>6}  {name}")


if __name__ == "__main__":
    main()
