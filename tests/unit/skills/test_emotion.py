import pytest

EMOTIONS = [
    ("expressJoy", "is_Joy", "joy"),
    ("expressSadness", "is_Sadness", "sadness"),
    ("expressSurprise", "is_Surprised", "surprise"),
    ("expressDisgust", "is_Disgust", "disgust"),
    ("expressAnger", "is_Angry", "anger"),
    ("expressFear", "is_Scared", "fear"),
    ("expressNeutral", "is_Neutral", "neutral"),
]


@pytest.mark.parametrize(("express", "_question", "emotion"), EMOTIONS)
def test_an_emotion_is_shown(robot, express, _question, emotion):
    getattr(robot, express)()

    assert [("Display.show_emotion", emotion)] == robot.commands


@pytest.mark.parametrize(("express", "question", "_emotion"), EMOTIONS)
def test_only_the_emotion_shown_last_is_felt(robot, express, question, _emotion):
    robot.expressJoy()
    robot.expressSadness()
    getattr(robot, express)()

    assert [question] == [asked for _, asked, _ in EMOTIONS if getattr(robot, asked)()]


def test_before_any_emotion_none_is_felt(robot):
    assert [] == [asked for _, asked, _ in EMOTIONS if getattr(robot, asked)()]
