import pytest

from learnblock import language
from learnblock.extensions import libraries

PROGRAM = """# How many steps were made.
steps = 0

# Dance a waltz.
def waltz(times, mood):
    repeat times:
        step()
    end
    print(mood, steps)
end

def step():
    steps += 1
    function.sleep(0.1)
end

main:
    waltz(3, "merry")
end
"""
CLAP = '''def clap(robot, times: int = 2) -> None:
    """Clap the hands."""
    for _ in range(times):
        robot.sleep(0.1)
        print("clap")


def applause(robot) -> None:
    clap(robot, 1)
    robot.clap(times=1)
'''


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


@pytest.fixture
def own(home):
    """Write a file of custom blocks."""
    (home / "skills").mkdir(parents=True)
    (home / "skills" / "clap.py").write_text(CLAP)
    return home / "skills" / "clap.py"


@pytest.fixture
def make():
    """Make a library of functions."""

    def of(name="dance", version="1.0.0", text=PROGRAM, functions=("waltz",), own=()):
        manifest = libraries.manifest(name, version, {"en": "Ball room"})
        return libraries.make(manifest, language.parse(text), functions, own, "program.bt")

    return of
