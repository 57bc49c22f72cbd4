"""Invitations into a pupil's world, and what a guest's page gets of it."""

import asyncio
from types import SimpleNamespace

import msgspec
import pytest

from learnblock.classroom.desk import Desk
from learnblock.classroom.guest_view import GuestView
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.limits import GUEST_PICTURES
from learnblock.classroom.pair_messages import (
    AnswerInvitation,
    AskClassmates,
    Classmates,
    InPair,
    Invite,
    LeaveWorld,
)
from learnblock.classroom.pairs import Pairs
from learnblock.classroom.questions import ServerQuestions
from learnblock.classroom.quota import Paces
from learnblock.classroom.roster import Pupil
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.messages.base import Role

GAME = messages.GuestRobot("game", "rival")
PROGRAM = messages.ProgramGiven(messages.GivenProgram("main:\n    pass\nend\n"))


class FakePage:
    """A page of a pupil, or of a guest, whose server gives these answers."""

    is_teacher = False

    def __init__(self, *answers):
        self.answers = {type(answer): answer for answer in answers}
        self.told = []
        self.asked = []
        self.is_closed = False

    @property
    def role(self):
        return Role.PUPIL

    def tell(self, message):
        self.told.append(message)

    async def ask(self, question, answer):
        self.asked.append(question)
        return self.answers.get(answer)

    async def send_away(self):
        self.is_closed = True

    @property
    def news(self):
        return [message for message in self.told if isinstance(message, InPair)][-1]

    @property
    def notes(self):
        return [
            message.message.code for message in self.told if isinstance(message, messages.Noted)
        ]


class Classroom:
    """Three pupils, each with a page."""

    def __init__(self, folder):
        self.clock = 0.0
        pupils = [Pupil(name[0].lower() * 10, name, None, 0.0) for name in ("Ana", "Ben", "Eva")]
        self.desks, self.pages = {}, {}
        self.pairs = Pairs(SimpleNamespace(pupils=pupils), self.desks, lambda: self.clock)
        shelf = HandInShelf(folder)
        for pupil in pupils:
            name = pupil.name
            desk = self.desks[pupil.id] = Desk(pupil, lambda: None, shelf)
            desk.sharing = self.pairs
            page = self.pages[name] = FakePage(GAME, PROGRAM)
            desk.joined(page)

    def desk(self, name):
        return next(desk for desk in self.desks.values() if desk.pupil.name == name)

    async def say(self, name, message):
        await self.desk(name).heard(self.pages[name], message)

    async def invite(self, host, guest):
        await self.say(host, Invite(self.desk(guest).pupil.id))

    async def play(self):
        """Let Ben play in Ana's world; return the page on which he sees it."""
        await self.pairs.let(on=True)
        await self.invite("Ana", "Ben")
        await self.say("Ben", AnswerInvitation(on=True))
        view = FakePage(messages.GuestTaken(fits=True))
        self.pairs.show(self.pairs.of(self.desk("Ana")), view)
        return view

    async def run(self):
        await self.pairs.before_run(self.desk("Ana"), self.pages["Ana"])

    def states(self):
        return [self.pages[name].news.state for name in ("Ana", "Ben")]


@pytest.fixture
def classroom(tmp_path):
    return Classroom(tmp_path)


async def refusal(doing):
    with pytest.raises(LearnBlockError) as refused:
        await doing
    return refused.value.phrase.code


def test_an_invitation_is_accepted_and_left(classroom):
    async def play():
        view = await classroom.play()
        assert classroom.states() == ["host", "guest"]
        await classroom.run()
        assert view.asked == [messages.TakeGuest("Ben", PROGRAM.program)]
        await classroom.say("Ana", LeaveWorld())
        assert view.is_closed
        assert classroom.states() == ["alone", "alone"]
        assert classroom.pages["Ben"].notes == ["class-pair-left"]
        # A run of the host's needs no guest any more.
        await classroom.run()

    asyncio.run(play())


@pytest.mark.parametrize("message", [AskClassmates(), Invite("a" * 10), AnswerInvitation(on=True)])
def test_nothing_is_possible_before_the_teacher_allows_it(classroom, message):
    assert asyncio.run(refusal(classroom.say("Ana", message))) == "class-pair-off"


def test_only_classmates_who_are_here_and_free_can_be_invited(classroom):
    async def ask():
        await classroom.pairs.let(on=True)
        await classroom.say("Eva", AskClassmates())
        first = classroom.pages["Eva"].told[-1]
        await classroom.invite("Ana", "Ben")
        assert await refusal(classroom.invite("Eva", "Ben")) == "class-pair-busy"
        assert await refusal(classroom.invite("Eva", "Eva")) == "class-pair-nobody"
        assert await refusal(classroom.invite("Ana", "Eva")) == "class-pair-already"
        await classroom.say("Ana", LeaveWorld())
        ben = classroom.desk("Ben")
        ben.left(classroom.pages["Ben"])
        await classroom.say("Eva", AskClassmates())
        second = classroom.pages["Eva"].told[-1]
        assert await refusal(classroom.invite("Eva", "Ben")) == "class-pair-nobody"
        return first, second

    first, second = asyncio.run(ask())
    assert isinstance(first, Classmates)
    assert [one.name for one in first.pupils] == ["Ana", "Ben"]
    assert [one.name for one in second.pupils] == ["Ana"]


def test_a_pupil_who_has_declined_is_left_alone_for_a_minute(classroom):
    async def ask():
        await classroom.pairs.let(on=True)
        await classroom.invite("Ana", "Ben")
        await classroom.say("Ben", AnswerInvitation(on=False))
        assert classroom.pages["Ana"].notes == ["class-pair-declined"]
        codes = [await refusal(classroom.invite("Ana", "Ben"))]
        classroom.clock = 61
        await classroom.invite("Ana", "Ben")
        await classroom.say("Ana", LeaveWorld())
        # An answer that comes too late.
        codes.append(await refusal(classroom.say("Ben", AnswerInvitation(on=True))))
        return codes

    assert asyncio.run(ask()) == ["class-pair-just-declined", "class-pair-no-invitation"]


def test_invitations_have_a_pace(classroom):
    async def ask():
        await classroom.pairs.let(on=True)
        for _ in range(3):
            await classroom.invite("Ana", "Ben")
            await classroom.say("Ana", LeaveWorld())
        return await refusal(classroom.invite("Ana", "Eva"))

    assert asyncio.run(ask()) == "class-too-fast"


@pytest.mark.parametrize(
    ("answers", "code"),
    [
        ([], "class-pair-silent"),
        ([messages.GuestRobot(lack="lesson")], "class-pair-lesson"),
        ([messages.GuestRobot(lack="project")], "class-pair-no-project"),
        ([messages.GuestRobot(lack="robot")], "class-pair-one-robot"),
    ],
)
def test_a_project_without_a_place_for_a_guest(classroom, answers, code):
    async def ask():
        await classroom.pairs.let(on=True)
        classroom.pages["Ana"].answers = {type(answer): answer for answer in answers}
        return await refusal(classroom.invite("Ana", "Ben"))

    assert asyncio.run(ask()) == code
    assert classroom.states() == ["alone", "alone"]


@pytest.mark.parametrize(
    ("program", "taken", "code"),
    [
        (None, messages.GuestTaken(fits=True), "class-pair-no-answer"),
        (messages.ProgramGiven(), messages.GuestTaken(fits=True), "class-pair-mistakes"),
        (PROGRAM, None, "class-pair-silent"),
        (PROGRAM, messages.GuestTaken(), "class-pair-unfit"),
    ],
)
def test_a_run_does_not_begin_without_the_guests_program(classroom, program, taken, code):
    async def run():
        view = await classroom.play()
        classroom.pages["Ben"].answers[messages.ProgramGiven] = program
        view.answers[messages.GuestTaken] = taken
        return await refusal(classroom.run())

    assert asyncio.run(run()) == code


def test_a_guest_without_the_world_on_the_page_is_waited_for(classroom):
    async def run():
        view = await classroom.play()
        classroom.pairs.show(classroom.pairs.of(classroom.desk("Ana")), None)
        assert classroom.pages["Ana"].news.away
        code = await refusal(classroom.run())
        # The guest's page has connected again, and so has the one with the program.
        ben, page = classroom.desk("Ben"), FakePage(PROGRAM)
        ben.joined(page)
        ben.left(classroom.pages["Ben"])
        classroom.pairs.show(classroom.pairs.of(ben), view)
        await classroom.run()
        return code, page.asked

    assert asyncio.run(run()) == ("class-pair-away", [messages.GiveProgram()])


def test_another_project_of_the_host_runs_without_the_guest(classroom):
    async def run():
        view = await classroom.play()
        ana, page = classroom.desk("Ana"), classroom.pages["Ana"]
        ana.see(page, messages.AtSeat(messages.Work(project="other")))
        await classroom.run()
        assert view.asked == []
        ana.see(page, messages.AtSeat(messages.Work(project="game")))
        classroom.pairs.renamed(ana, page, "match")
        return classroom.pairs.of(ana).project

    assert asyncio.run(run()) == "match"


def test_the_teacher_ends_all_pairs(classroom):
    async def end():
        view = await classroom.play()
        await classroom.pairs.let(on=False)
        return view.is_closed, classroom.pages["Ana"].notes, classroom.pages["Ben"].notes

    assert asyncio.run(end()) == (True, ["class-pair-over"], ["class-pair-over"])
    assert classroom.states() == ["alone", "alone"]
    assert not classroom.pages["Eva"].news.allowed


@pytest.mark.parametrize(("gone", "stays"), [("Ana", "Ben"), ("Ben", "Ana")])
def test_a_pupil_whose_pages_have_gone_leaves_after_a_while(classroom, monkeypatch, gone, stays):
    monkeypatch.setattr("learnblock.classroom.pairs._GRACE", 0)

    async def leave():
        await classroom.play()
        desk = classroom.desk(gone)
        desk.left(classroom.pages[gone])
        classroom.pairs.left(desk)
        while classroom.pages[stays].news.state != "alone":
            await asyncio.sleep(0)

    asyncio.run(leave())
    assert classroom.pages[stays].notes == ["class-pair-left"]


def test_a_pupil_who_comes_back_and_leaves_again_has_the_whole_time(classroom, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.pairs._GRACE", 0)

    async def reload():
        await classroom.play()
        ben, page = classroom.desk("Ben"), FakePage(PROGRAM)
        ben.left(classroom.pages["Ben"])
        classroom.pairs.left(ben)
        ben.joined(page)
        ben.left(page)
        # The first time is over in the next turn of the event loop.
        for _ in range(3):
            await asyncio.sleep(0)
        return classroom.pairs.of(ben)

    assert asyncio.run(reload()) is not None
    assert classroom.pages["Ana"].notes == []


def test_an_invitation_without_an_answer_ends(classroom, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.pairs._WAITING", 0)

    async def wait():
        await classroom.pairs.let(on=True)
        await classroom.invite("Ana", "Ben")
        while classroom.pages["Ana"].news.state != "alone":
            await asyncio.sleep(0)

    asyncio.run(wait())
    assert classroom.pages["Ana"].notes == ["class-pair-silence"]
    assert classroom.pages["Ben"].news.state == "alone"


# What a server answers.


def encoded(message):
    return msgspec.json.encode(message).decode()


@pytest.mark.parametrize(
    ("texts", "answer"),
    [
        ([encoded(GAME)], GAME),
        ([encoded(PROGRAM), encoded(GAME)], GAME),
        (['{"kind":"GuestRobot","project":7}'], None),
        ([], None),
    ],
)
def test_a_server_answers_in_time_or_not(texts, answer):
    async def ask():
        async def send(question):
            assert question == messages.FindGuestRobot()
            assert all(map(questions.takes, texts))

        questions = ServerQuestions(send, patience=0.01)
        return await questions.ask(messages.FindGuestRobot(), messages.GuestRobot)

    assert asyncio.run(ask()) == answer


@pytest.mark.parametrize("text", ['{"kind":"Done","request":1}', "", "{", '{"kind":"GuestRobots"}'])
def test_all_else_is_for_the_page(text):
    assert not ServerQuestions(None).takes(text)


# What a guest's page gets.


class Socket:
    """A page's websocket, or a server's, with what it receives."""

    def __init__(self, *texts):
        self.texts = list(texts)
        self.sent = []
        self.code = None

    async def receive(self):
        if self.texts:
            return {"type": "websocket.receive", "text": self.texts.pop(0)}
        return {"type": "websocket.disconnect"}

    async def send_text(self, text):
        self.sent.append(msgspec.json.decode(text))

    async def send(self, text):
        self.sent.append(msgspec.json.decode(text))

    async def close(self, code):
        self.code = code

    async def __aiter__(self):
        for text in self.texts:
            yield text


def shown(*texts):
    """What a guest's page gets of what the host's server sends."""
    page, lost = Socket(), []

    async def lose():
        lost.append("lost")

    asyncio.run(GuestView(page, Paces(), lose)._show(Socket(*texts)))
    return page, lost


def test_a_guest_gets_what_shows_the_world_and_nothing_else():
    kinds = ["Document", "Printed", "Projects", "RunState", "Variables", "Ended", "Nonsense"]
    page, _ = shown(*(f'{{"kind":"{kind}"}}' for kind in kinds), "", "{", b"frame")
    assert [message["kind"] for message in page.sent] == ["RunState", "Ended"]
    assert page.code == 1012


def test_a_guest_gets_no_message_that_is_too_large():
    page, _ = shown(f'{{"kind":"Scene","x":"{"x" * 2_000_000}"}}', '{"kind":"Ended"}')
    assert [message["kind"] for message in page.sent] == ["Ended"]


def test_only_the_newest_picture_of_what_moves_counts():
    moves = [f'{{"kind":"Telemetry","time":{i}}}' for i in range(50)]
    page, _ = shown(*moves, '{"kind":"Ended"}')
    assert page.sent == [{"kind": "Telemetry", "time": 49}, {"kind": "Ended"}]


def test_pictures_have_a_rate():
    async def show():
        page = Socket()
        view = GuestView(page, Paces(), None)
        showing = asyncio.create_task(view._show_moves())
        began = asyncio.get_running_loop().time()
        while len(page.sent) < 4:
            await view._see('{"kind":"Telemetry"}')
            await asyncio.sleep(0)
        showing.cancel()
        return asyncio.get_running_loop().time() - began

    assert asyncio.run(show()) >= 2.9 / GUEST_PICTURES


def test_the_greeting_says_nothing_about_the_host():
    welcome = {
        "kind": "Welcome",
        "version": "0",
        "robots": [],
        "folder": "/home/ana",
        "worlds": [1],
    }
    page, _ = shown(msgspec.json.encode(welcome).decode(), '{"kind":"Welcome"')
    assert "/home/ana" not in str(page.sent)
    assert [message["worlds"] for message in page.sent] == [[], []]


def test_a_project_that_cannot_be_opened_ends_the_pair():
    failed = messages.Failed(Phrase("project-missing"), "Open")
    assert shown(encoded(failed))[1] == ["lost"]
    assert shown(encoded(messages.Failed(Phrase("project-missing"), "Run")))[1] == []


@pytest.mark.parametrize(
    ("text", "passes"),
    [
        ('{"kind":"HoldKeys","keys":["up"]}', True),
        ('{"kind":"HoldKeys","keys":["up"],"x":"' + "x" * 2000 + '"}', False),
        ('{"kind":"EditText","edit":1,"notation":"python","text":""}', False),
        ('{"kind":"Run"}', False),
        ('{"kind":"TakeGuest","name":"x","program":{"text":""}}', False),
        ("", False),
        ("{", False),
    ],
)
def test_a_guest_sends_keys_and_nothing_else(text, passes):
    page, server = Socket(text), Socket()
    asyncio.run(GuestView(page, Paces(), None)._hear(server))
    assert bool(server.sent) is passes
    assert page.sent == []


def test_a_guests_request_is_answered():
    page, server = Socket('{"kind":"Run","request":4}'), Socket()
    asyncio.run(GuestView(page, Paces(), None)._hear(server))
    assert (page.sent[0]["kind"], page.sent[0]["request"]) == ("Failed", 4)
    assert server.sent == []
