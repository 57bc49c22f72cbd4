"""A class of thirty pupils, in each state of the wall that needs no waiting."""

from contextlib import ExitStack, contextmanager

from classes import hand_in

LESSON, TITLE = "1-03-square", "A square with a loop"
#: In many scripts, some of them long.
ASKING, RUNNING, EDITING = ("Elif", "Maximiliano"), ("美咲", "سارة"), ("Юля", "Inés")
HANDED_IN = ("Carla", "Jonas", "Alejandra")
NOT_HERE = (
    *("Ada", "Ben", "Grace", "Hugo", "Omar", "देव", "Kim", "Łukasz", "Paula", "Nora", "Quinn"),
    *("Rosa", "Sami", "Wim", "Lena", "Tariq", "Guadalupe", "Mateo", "Zoë", "Noah", "Mia"),
)
NAMES = (*ASKING, *RUNNING, *EDITING, *HANDED_IN, *NOT_HERE)
#: Drives one side of the square, over and over.
SIDES = """main:
    while True:
        function.move_straight(100)
        function.sleep(2)
        function.turn_right(90)
    end
end
"""


@contextmanager
def thirty_at_work(room):
    """Thirty pupils of an open class, nine of them with a page."""
    pupils = {name: room.pupil(name) for name in NAMES}
    with ExitStack() as stack:
        wall = stack.enter_context(room.wall())
        wall.say("HandOut", lesson=LESSON, project=TITLE)
        wall.hear("Wall", lesson=LESSON)
        pages = {
            name: stack.enter_context(pupils[name].page())
            for name in (*ASKING, *RUNNING, *EDITING, *HANDED_IN)
        }
        for name, page in pages.items():
            step = 4 if name in (*ASKING, *HANDED_IN) else 2
            page.say("StartLesson", lesson=LESSON, name=TITLE, step=step)
            page.hear("LessonShown", step=step)
        for name in ASKING:
            pages[name].say("AskForHelp", on=True, question="One side of my square is missing")
        for name in RUNNING:
            pages[name].type(SIDES)
            pages[name].say("Run")
        for name in HANDED_IN:
            hand_in(pages[name], LESSON, 4)
        yield pupils
