"""Our detectors as components, called by the real Ice in another process."""

import json
import subprocess

import pytest

from ice_runtime import PYTHON, require_ice, written
from learnblock.errors import LearnBlockError, SettingsError, UnknownNameError
from learnblock.ice.robocomp import Layout
from learnblock.perception.robocomp import COMPONENTS, PixelOrder, serve
from learnblock.perception.sources import TABLE
from learnblock.storage.settings import file
from places import TESTS
from shown_pictures import TAG_AT, a_face, a_tag, blank

VIEWERS = TESTS / "helpers" / "ice" / "viewers.py"
TAG = {"id": 8, "cx": TAG_AT[0], "cy": TAG_AT[1], "cameraId": ""}


def shown(folder, identity, port, *pictures, layout=Layout.TOOL, encoding="1.1"):
    """The findings of the component at that port, as received by the real Ice.

    A picture is (frame, order), or (bytes, width, height, depth) for a client with wrong sizes.
    """
    require_ice()
    plan = {
        "slices": str(written(folder, layout)),
        "port": port,
        "identity": identity,
        "encoding": encoding,
        "pictures": [said(folder, number, *one) for number, one in enumerate(pictures)],
    }
    command = [PYTHON, str(VIEWERS), json.dumps(plan)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    return json.loads(done.stdout)


def said(folder, number, picture, *numbers):
    path = folder / f"{number}.rgb"
    if isinstance(picture, bytes):
        path.write_bytes(picture)
        width, height, depth = numbers
    else:
        path.write_bytes(picture.tobytes())
        rows, columns, depth = picture.shape
        width, height = (rows, columns) if numbers[0] is PixelOrder.ROWS else (columns, rows)
    return {"file": str(path), "width": width, "height": height, "depth": depth}


@pytest.fixture
def tags():
    adapter, port = serve("apriltag", port=0)
    with adapter:
        yield port


@pytest.fixture
def emotions():
    adapter, port = serve("emotionrecognition", port=0, drawn=True)
    with adapter:
        yield port


@pytest.mark.parametrize("layout", Layout)
@pytest.mark.parametrize("encoding", ["1.0", "1.1"])
def test_another_process_asks_for_tags(tags, tmp_path, layout, encoding):
    found = shown(
        tmp_path, "apriltag", tags, (a_tag(), PixelOrder.ROWS), (blank(), PixelOrder.ROWS),
        layout=layout, encoding=encoding,
    )  # fmt: skip
    assert found == [[TAG], []]


@pytest.mark.parametrize("order", PixelOrder)
def test_whichever_number_carries_the_rows_the_picture_is_understood(tags, tmp_path, order):
    upright = a_tag(height=320, width=300)
    assert shown(tmp_path, "apriltag", tags, (a_tag(), order), (upright, order)) == [[TAG], [TAG]]


@pytest.mark.parametrize("order", PixelOrder)
def test_a_chosen_order_is_kept(tmp_path, order):
    adapter, port = serve("apriltag", port=0, order=order)
    with adapter:
        found = shown(tmp_path, "apriltag", port, *[(a_tag(), one) for one in PixelOrder])
    assert found == [[TAG] if one is order else [] for one in PixelOrder]


@pytest.mark.parametrize("layout", Layout)
def test_another_process_asks_for_emotions(emotions, tmp_path, layout):
    (found,) = shown(
        tmp_path, "emotionrecognition", emotions, (a_face("joy"), PixelOrder.ROWS), layout=layout
    )
    (seen,) = found
    assert seen["emotion"] == "Happy"
    middle = seen["x"] + seen["w"] / 2, seen["y"] + seen["h"] / 2
    assert middle == pytest.approx((130, 120), abs=25)


def test_wrong_picture_sizes_are_rejected_and_the_next_picture_is_searched(tags, tmp_path):
    *refused, found = shown(
        tmp_path, "apriltag", tags,
        (b"", 240, 320, 3), (b"abc", -1, -1, 3), (b"abc", 2**31 - 1, 2**31 - 1, 3),
        (b"abc", 0, 0, 0), (b"abcd", 1, 1, 4), (a_tag(), PixelOrder.ROWS),
    )  # fmt: skip
    beginnings = ("PictureError: A picture of", "PictureError: The image sent")
    assert all(one.startswith(beginnings) for one in refused)
    assert found == [TAG]


def test_faces_of_people_are_not_searched_unless_the_settings_allow_it():
    with pytest.raises(LearnBlockError, match=r"5\(1\)\(f\) of the AI Act") as refused:
        serve("emotionrecognition", port=0)
    assert refused.value.phrase.code == "perception-component-not-allowed"
    assert "--only-drawn-faces" in str(refused.value)


def test_faces_of_people_are_searched_if_emotions_are_turned_on():
    TABLE.change("emotions_on_cameras", "true")
    adapter, port = serve("emotionrecognition", port=0)
    adapter.close()
    assert port > 0


def test_a_taken_port_is_reported(tags):
    with pytest.raises(LearnBlockError, match=rf"cannot listen at 127.0.0.1:{tags} \(.*--port"):
        serve("apriltag", port=tags)


def test_there_are_no_other_components():
    with pytest.raises(UnknownNameError, match="Did you mean 'apriltag'"):
        serve("apriltags")


def test_wrong_settings_are_reported():
    file().write_text("[perception]\nlayout = 3\n")
    with pytest.raises(SettingsError, match=r"'perception\.layout' is 3"):
        serve("apriltag", port=0)


def test_the_usual_ports_are_robocomps():
    assert {name: kind.port for name, kind in COMPONENTS.items()} == {
        "apriltag": 25000,
        "emotionrecognition": 10006,
    }
