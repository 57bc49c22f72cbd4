"""Questions of the class to a pupil's server, which may not answer, or wrongly."""

import asyncio

import msgspec
import pytest

from learnblock.classroom.questions import ServerQuestions
from learnblock.server import messages

GAME = messages.GuestRobot("game", "rival")
PROGRAM = messages.ProgramGiven(messages.GivenProgram("main:\n    pass\nend\n"))


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
