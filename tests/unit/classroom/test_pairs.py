"""Invitations into a pupil's world, and the guest's program before each run."""

import asyncio

import pytest

from learnblock.classroom.pair_messages import (
    AnswerInvitation,
    AskClassmates,
    Classmates,
    InPair,
    Invite,
    LeaveWorld,
)
from learnblock.classroom.pairs import Pairs
from learnblock.errors import LearnBlockError
from learnblock.server import messages
from small_classroom import Classroom, FakePage

GAME = messages.GuestRobot("game", "rival")
PROGRAM = messages.ProgramGiven(messages.GivenProgram("main:\n    pass\nend\n"))


class Page(FakePage):
    @property
    def news(self):
        return self.newest(InPair)


class PlayRoom(Classroom):
    """Three pupils, each with a page."""

    def __init__(self, folder):
        super().__init__(("Ana", "Ben", "Eva"))
        self.pairs = Pairs(self.roster, self.desks, lambda: self.clock)
        self.seat(folder, lambda: Page(GAME, PROGRAM), sharing=self.pairs)

    async def say(self, name, message):
        await self.desk(name).heard(self.pages[name], message)

    async def invite(self, host, guest):
        await self.say(host, Invite(self.desk(guest).pupil.id))

    async def play(self):
        """Let Ben play in Ana's world; return the page on which he sees it."""
        await self.pairs.let(on=True)
        await self.invite("Ana", "Ben")
        await self.say("Ben", AnswerInvitation(on=True))
        view = Page(messages.GuestTaken(fits=True))
        self.pairs.show(self.pairs.of(self.desk("Ana")), view)
        return view

    async def run(self):
        await self.pairs.before_run(self.desk("Ana"), self.pages["Ana"])

    def states(self):
        return [self.pages[name].news.state for name in ("Ana", "Ben")]


@pytest.fixture
def classroom(tmp_path):
    return PlayRoom(tmp_path)


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
        assert await refusal(classroom.invite("Eva", "Eva")) == "class-classmate-away"
        assert await refusal(classroom.invite("Ana", "Eva")) == "class-pair-already"
        await classroom.say("Ana", LeaveWorld())
        ben = classroom.desk("Ben")
        ben.left(classroom.pages["Ben"])
        await classroom.say("Eva", AskClassmates())
        second = classroom.pages["Eva"].told[-1]
        assert await refusal(classroom.invite("Eva", "Ben")) == "class-classmate-away"
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

    assert asyncio.run(ask()) == ["class-classmate-declined", "class-pair-no-invitation"]


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
        ben, page = classroom.desk("Ben"), Page(PROGRAM)
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
        ben, page = classroom.desk("Ben"), Page(PROGRAM)
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
