import pytest

from learnblock import robots
from learnblock.devices import Emotion
from learnblock.perception import Face, FaceEmotion


def test_two_faces_in_one_place_are_still_there(robot):
    robot.set_detections("faces", (Face(10, 100, 30, 30), Face(40, 100, 30, 30)))

    assert robot.is_there_face()
    assert robot.is_left_face()


@pytest.mark.parametrize(
    ("x", "y", "where"),
    [
        (10, 100, {"left"}),
        (280, 10, {"right", "up"}),
        (145, 105, {"center"}),
        (145, 200, {"down"}),
    ],
)
def test_a_face_is_placed_on_a_grid_of_three_by_three(robot, x, y, where):
    robot.set_detections("faces", (Face(x, y, 30, 30),))
    places = ("left", "right", "up", "down", "center")

    assert where == {one for one in places if getattr(robot, f"is_{one}_face")()}


def test_without_a_face_there_is_none(robot):
    robot.set_detections("faces", ())

    assert not robot.is_there_face()


FACE = Face(10, 10, 30, 30)
WORDS = {
    Emotion.JOY: "happy",
    Emotion.SADNESS: "sad",
    Emotion.NEUTRAL: "neutral",
    Emotion.ANGER: "angry",
    Emotion.SURPRISE: "surprised",
    Emotion.FEAR: "scared",
    Emotion.DISGUST: "disgusted",
}


@pytest.mark.parametrize("emotion", WORDS)
def test_a_face_with_the_emotion_is_enough(robot, emotion):
    robot.set_detections("emotions", (FaceEmotion(FACE, emotion.value, 0.9),))

    felt = [one for one in WORDS.values() if getattr(robot, f"is_any_face_{one}")()]
    assert [WORDS[emotion]] == felt


def test_any_of_the_faces_is_enough(robot):
    found = [FaceEmotion(FACE, emotion, 0.9) for emotion in ("fear", "joy")]
    robot.set_detections("emotions", tuple(found))

    assert robot.is_any_face_scared()
    assert robot.is_any_face_happy()


def test_without_an_emotion_detector_no_face_has_an_emotion(robot):
    robot.set_detections("emotions", None)

    assert robot.is_any_face_happy() is False


@pytest.mark.parametrize("twin", ["sim-ebo", "sim-cozmo"])
def test_people_are_seen_by_a_robot_that_looks_up(twin):
    with robots.find(twin).load()(world="people") as robot:
        robot.look_up()
        robot.sleep(1)
        assert robot.is_center_face()
        assert robot.is_any_face_happy()
        robot.look_front()
        robot.sleep(1)
        assert not robot.is_center_face()


@pytest.mark.parametrize("twin", ["sim-ebo", "sim-cozmo"])
@pytest.mark.parametrize("look", ["look_front", "look_up"])
def test_faces_are_seen_by_a_robot_that_looks_ahead_and_by_one_that_looks_up(twin, look):
    with robots.find(twin).load()(world="faces") as robot:
        getattr(robot, look)()
        robot.sleep(1)
        assert robot.is_there_face()
        assert robot.is_any_face_happy()
