"""A small lesson: three steps with a question, checks and a puzzle."""

from learnblock.lessons.packing import pack
from learnblock.lessons.reading import read_files

NAME = "small"
LESSON = """
lesson = 1
level = 1
minutes = 10
title = { en = "First drive", es = "Primer viaje" }
aims = ["Drive and stop"]
robots = ["sim-cozmo", "sim-thymio"]
picture = "start.svg"

[[step]]
title = { en = "What happens?", es = "¿Qué pasa?" }
phase = "predict"
program = "start.bt"
world = "empty"
blocks = "first-steps"
[step.text]
en = '''
Look at these blocks. **Don't run them yet.**

```blocks
function.move_straight(40)
function.sleep(2)
function.stop_bot()
```

![The robot](start.svg) <b>no HTML</b>
'''
es = "Mira estos bloques. **No los ejecutes todavía.**"
[step.quiz]
question = { en = "Where does the robot drive?", es = "¿Adónde va el robot?" }
[[step.quiz.choices]]
text = { en = "Forward", es = "Adelante" }
right = true
because = "The speed is positive."
[[step.quiz.choices]]
text = { en = "Backward", es = "Atrás" }
because = "A negative speed would do that."

[[step]]
title = { en = "Drive 100 mm", es = "Avanza 100 mm" }
phase = "modify"
text = { en = "Make the robot drive **100 mm**, and stop.", es = "Avanza **100 mm** y para." }
variants = 1
seconds = 20
[[step.check]]
kind = "drives"
at_least = 100
[[step.check]]
kind = "ends"
[[step.check]]
kind = "uses"
skill = "stop_bot"
optional = true
[[step.hint]]
check = "drives"
say = ["Look at the number in the wait block.", "The wait is too short.", "Time makes distance."]

[[step]]
title = { en = "Put it in order", es = "Ordénalo" }
phase = "make"
text = { en = "Build the program from the pieces.", es = "Construye el programa." }
[step.puzzle]
program = "puzzle.bt"
distractors = ["function.turn(90)"]
"""
START = """main:
    function.move_straight(40)
    function.sleep(1)
    function.stop_bot()
end
"""
#: A program that earns the stars of the second step.
SOLUTION = START.replace("sleep(1)", "sleep(4)")
PUZZLE = """main:
    function.expressJoy()
    function.sleep(1)
    function.stop_bot()
end
"""
SHAPE = '<rect width="80" height="40" fill="#f60"/>'
PICTURE = f'<svg xmlns="http://www.w3.org/2000/svg" width="80" height="40">{SHAPE}</svg>'
SECRET = "the note that only the teacher reads"
FILES = {
    "lesson.toml": LESSON,
    "programs/start.bt": START,
    "programs/puzzle.bt": PUZZLE,
    "pictures/start.svg": PICTURE,
    "teacher/teacher.toml": '[solutions]\n2 = "two.bt"\n',
    "teacher/solutions/two.bt": SOLUTION,
    "teacher/notes.md": SECRET,
}


def packed(*, pictures=None, **changed):
    """The lesson as a file; `changed` are the texts of `lesson.toml` to replace."""
    files = dict(FILES)
    for old, new in changed.items():
        files["lesson.toml"] = files["lesson.toml"].replace(old, new)
    encoded = {path: text.encode() for path, text in files.items()}
    more = {f"pictures/{name}": content for name, content in (pictures or {}).items()}
    return pack(read_files(NAME, encoded | more))


def put_in(home, *, name=NAME, **changed):
    """Put the lesson among the user's own; `changed` as in `packed`."""
    folder = home / "lessons"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.lblesson").write_bytes(packed(**changed))
