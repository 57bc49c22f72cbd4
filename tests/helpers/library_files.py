"""Library files for the fuzzer: the zip, its manifest, functions and Python."""

from learnblock.extensions import libraries

MANIFEST = """learnblock = 1
name = "dance"
version = "1.2.0"
description = "Dances for every robot."

[title]
en = "Dances"
es = "Bailes"
"""
FUNCTIONS = """# How many steps were made.
steps = [1, 2]

# Dance a waltz.
def waltz(times, mood):
    for i from 1 to times:
        step(mood=sqrt(i))
    end
    return `len(steps)`
end

def step(mood):
    steps += [mood]
    function.sleep(0.1)
end
"""
PYTHON = """import math

PAIRS = {"a": 1}


def clap(robot, times: int = 2) -> None:
    \"\"\"Clap.\"\"\"
    for _ in range(times):
        robot.sleep(0.1)
        applause(robot, "ñ")


def applause(robot, text):
    robot.clap()
"""


def read_manifest(text):
    return _read(manifest=text)


def read_functions(text):
    """Check that a readable library stays the same when it is packed."""
    library = _read(functions=text)
    again = libraries.unpack(libraries.pack(library), "dance.lblib")
    if again.files != library.files:
        raise AssertionError("a library does not come back from its file")


def read_python(text):
    """Check that a readable library can be renamed, and is valid Python afterwards."""
    library = _read(python=text)
    name = next(iter(library.skills))
    compile(
        libraries.renamed(library, {name: "renamed_skill"}).modules["clap.py"], "clap.py", "exec"
    )


def read_archive(text):
    libraries.unpack(text.encode("latin-1", "replace"), "dance.lblib")


def archives():
    """Return a library in one file, as a string with a letter for each byte."""
    return (libraries.pack(_read(functions=FUNCTIONS)).decode("latin-1"),)


def _read(manifest=MANIFEST, functions="", python=PYTHON):
    texts = {"library.toml": manifest, "functions.bt": functions, "clap.py": python}
    files = {name: text.encode("utf-8", "surrogatepass") for name, text in texts.items()}
    return libraries.from_files(files, "dance")
