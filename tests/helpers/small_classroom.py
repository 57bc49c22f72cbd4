"""A few pupils of a class at their desks, without servers and sockets."""

from types import SimpleNamespace

from learnblock.classroom.desk import Desk
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.roster import Pupil
from learnblock.server import messages
from learnblock.server.messages.base import Role


class FakePage:
    """A page of a pupil, of a guest or of the teacher, whose server gives these answers."""

    def __init__(self, *answers, role=Role.PUPIL):
        self.role = role
        self.is_teacher = role is not Role.PUPIL
        self.answers = {type(answer): answer for answer in answers}
        self.told = []
        self.asked = []
        self.orders = []
        self.is_closed = False

    def tell(self, message):
        self.told.append(message)

    async def ask(self, question, answer):
        self.asked.append(question)
        return self.answers.get(answer)

    async def order(self, message):
        self.orders.append(message)

    async def send_away(self):
        self.is_closed = True

    def newest(self, kind):
        return [message for message in self.told if isinstance(message, kind)][-1]

    @property
    def notes(self):
        return [
            message.message.code for message in self.told if isinstance(message, messages.Noted)
        ]


class Classroom:
    """Pupils, each with a page.

    Args:
        names: of the pupils; each begins with another letter.
    """

    def __init__(self, names):
        self.clock = 0.0
        pupils = [Pupil(name[0].lower() * 10, name, None, 0.0) for name in names]
        self.roster = SimpleNamespace(pupils=pupils)
        self.desks, self.pages = {}, {}

    def seat(self, folder, page, **services):
        """Give each pupil a desk that uses these services, and a page."""
        shelf = HandInShelf(folder)
        for pupil in self.roster.pupils:
            desk = self.desks[pupil.id] = Desk(pupil, lambda: None, shelf)
            for name, service in services.items():
                setattr(desk, name, service)
            self.pages[pupil.name] = page()
            desk.joined(self.pages[pupil.name])

    def desk(self, name):
        return next(desk for desk in self.desks.values() if desk.pupil.name == name)
