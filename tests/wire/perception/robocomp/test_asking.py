"""Third-party components instead of our detectors, built with the real Ice in another process."""

import numpy as np
import pytest

from ice_runtime import components
from learnblock.errors import RobotConnectionError
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import FoundEmotion, FoundTag
from learnblock.ice.server import Adapter, Servant
from learnblock.perception import Face, FaceEmotion, Sight
from learnblock.perception.robocomp import AskedEmotions, AskedTags, PixelOrder, serve
from learnblock.perception.robocomp.asking import MOST_FOUND
from learnblock.testing import Fault, Relay
from shown_pictures import TAG_AT, a_face, a_tag, blank

SQUARE = blank()
SQUARE[60:100, 20:60] = 0


class Answering:
    """A component of ours that gives the answers chosen by a test."""

    def __init__(self, *found):
        self.found = found

    def processimage(self, picture):
        return self.found


def answering(identity, *found):
    """An adapter with such a component, and its port."""
    adapter = Adapter()
    servant = Servant(interfaces(Layout.TOOL)[identity], Answering(*found))
    return adapter, adapter.serve({identity: servant})


@pytest.mark.parametrize("layout", Layout)
@pytest.mark.parametrize("order", PixelOrder)
def test_a_foreign_component_finds_our_tags_whichever_number_it_reads_as_the_rows(
    tmp_path, layout, order
):
    objects = ("apriltag", {"order": str(order)})
    with (
        components(tmp_path, layout, objects, quiet=True) as running,
        AskedTags("127.0.0.1", running.ports[0], timeout=10) as asked,
    ):
        (tag,) = asked.detect(Sight(SQUARE))
        assert (tag.id, tag.center, tag.pose) == (7, (39, 79), None)
        assert tag.is_left
        assert asked.detect(Sight(blank())) == ()


def test_robocomps_rows_are_sent_to_a_component_that_shows_nothing(tmp_path):
    with components(tmp_path, Layout.ROBOT, "apriltag") as running:
        with AskedTags("127.0.0.1", running.ports[0], timeout=10) as asked:
            (tag,) = asked.detect(Sight(blank(180, 200)))
        assert (tag.id, tag.center) == (8, (160, 120))
        # After two pictures of a tag, which it did not find.
        told = [running.told() for _ in range(3)]
        assert told[-1] == ["processimage", 180, 200, 3, 108_000]


def test_a_chosen_order_is_not_detected(tmp_path):
    with components(tmp_path, Layout.TOOL, "apriltag") as running:
        place = "127.0.0.1", running.ports[0]
        with AskedTags(*place, order=PixelOrder.COLUMNS, timeout=10) as asked:
            asked.detect(Sight(blank()))
        assert running.told() == ["processimage", 320, 240, 3, 230_400]


@pytest.mark.parametrize("layout", Layout)
def test_a_foreign_component_names_emotions_differently(tmp_path, layout):
    found = [
        [100, 50, 60, 60, "Surprised"], [10, 20, 50, 50, "happy"],
        [0, 0, 9, 9, "Bored"], [310, 230, 40, 40, "Sad"], [-400, 0, 50, 50, "Angry"],
    ]  # fmt: skip
    objects = ("emotionrecognition", {"found": found})
    frame = a_face("joy")
    with components(tmp_path, layout, objects) as running:
        with AskedEmotions("127.0.0.1", running.ports[0], timeout=10) as asked:
            assert asked.detect(Sight(frame)) == (
                FaceEmotion(Face(10, 20, 50, 50), "joy", 1.0),
                FaceEmotion(Face(100, 50, 60, 60), "surprise", 1.0),
                FaceEmotion(Face(310, 230, 10, 10), "sadness", 1.0),
            )
        assert running.told() == ["processimage", 240, 320, 3, int(frame.sum(dtype=np.int64))]


def test_our_component_finds_the_same_as_our_detector():
    adapter, port = serve("apriltag", port=0)
    with adapter, AskedTags("127.0.0.1", port) as asked:
        (tag,) = asked.detect(Sight(a_tag(3)))
        assert (tag.id, tag.center) == (3, TAG_AT)


@pytest.mark.parametrize("order", PixelOrder)
def test_our_component_shows_the_order_it_was_given(order):
    adapter, port = serve("apriltag", port=0, order=order)
    with adapter, AskedTags("127.0.0.1", port) as asked:
        assert asked.find_order() is order


def test_a_component_that_refuses_the_other_order_shows_its_own():
    class Strict(Answering):
        def processimage(self, picture):
            if picture.width < picture.height:
                raise ValueError("too narrow")
            return [FoundTag(7, 231, 149)]

    with Adapter() as adapter:
        servant = Servant(interfaces(Layout.TOOL)["apriltag"], Strict())
        with AskedTags("127.0.0.1", adapter.serve({"apriltag": servant})) as asked:
            assert asked.find_order() is PixelOrder.COLUMNS


def test_tags_that_cannot_be_in_the_picture_are_left_out():
    wrong = [(587, 5, 5), (-1, 5, 5), (3, -1, 5), (3, 320, 5), (3, 5, 240), (3, 2**31 - 1, 0)]
    adapter, port = answering("apriltag", *(FoundTag(*one) for one in [*wrong, (3, 319, 239)]))
    with adapter, AskedTags("127.0.0.1", port) as asked:
        (tag,) = asked.detect(Sight(blank()))
        assert (tag.id, tag.center) == (3, (319, 239))


def test_a_component_with_an_endless_answer_is_not_read_forever():
    adapter, port = answering("apriltag", *[FoundTag(1, 2, 3)] * 5000)
    with adapter, AskedTags("127.0.0.1", port) as asked:
        assert len(asked.detect(Sight(blank()))) == MOST_FOUND


def test_faces_of_no_size_are_left_out():
    wrong = [(5, 5, 0, 9), (5, 5, 9, -9), (2**31 - 1, 0, 2**31 - 1, 9)]
    adapter, port = answering("emotionrecognition", *(FoundEmotion(*one, "Sad") for one in wrong))
    with adapter, AskedEmotions("127.0.0.1", port) as asked:
        assert asked.detect(Sight(blank())) == ()


def test_a_missing_component_is_reported_with_what_to_do():
    with AskedTags("127.0.0.1", 1) as asked, pytest.raises(RobotConnectionError) as refused:
        asked.detect(Sight(blank()))
    phrase = refused.value.phrase
    assert phrase.code == "perception-component-unreachable"
    assert (phrase.values["component"], phrase.values["address"]) == ("apriltag", "127.0.0.1:1")
    assert "learnblock perception set apriltag --default" in str(phrase)


def test_another_component_in_its_place_is_reported():
    adapter, port = serve("apriltag", port=0)
    with (
        adapter,
        AskedEmotions("127.0.0.1", port) as asked,
        pytest.raises(RobotConnectionError) as refused,
    ):
        asked.detect(Sight(blank()))
    assert refused.value.phrase.code == "perception-component-refused"


def test_the_wait_for_a_component_ends_at_the_timeout(tmp_path):
    objects = ("apriltag", {"wait": 30})
    with (
        components(tmp_path, Layout.TOOL, objects, quiet=True) as running,
        AskedTags("127.0.0.1", running.ports[0], timeout=0.5) as asked,
        pytest.raises(RobotConnectionError, match="did not answer in time"),
    ):
        asked.detect(Sight(blank()))


def test_after_the_link_broke_the_next_request_succeeds():
    adapter, port = serve("apriltag", port=0)
    with (
        adapter,
        Relay(("127.0.0.1", port)) as relay,
        AskedTags("127.0.0.1", relay.port) as asked,
    ):
        assert len(asked.detect(Sight(a_tag()))) == 1
        relay.fault = Fault.CUT
        with pytest.raises(RobotConnectionError, match="cannot be reached"):
            asked.detect(Sight(a_tag()))
        relay.fault = Fault.NONE
        assert len(asked.detect(Sight(a_tag()))) == 1
