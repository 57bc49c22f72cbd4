import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from learnblock import devices
from learnblock.devices import (
    DEVICE_TYPES,
    MP3,
    Base,
    Camera,
    Device,
    Display,
    Emotion,
    Gyroscope,
    Infrared,
    JointMotor,
    Led,
    Matrix,
    Pen,
    RGBLed,
    Screen,
    Speaker,
    clamped,
    number,
    whole,
)
from learnblock.errors import DeviceValueError
from learnblock.i18n import Phrase


class Log(list):
    """Records every call of the functions that it makes."""

    def __getitem__(self, name):
        return lambda *args: self.append((name, *args))


@pytest.fixture
def log():
    return Log()


def test_every_type_of_device_is_listed():
    kinds = {
        name: value
        for name, value in vars(devices).items()
        if isinstance(value, type) and issubclass(value, Device) and name not in
        {"Device", "Sensor"}
    }  # fmt: skip
    assert kinds == dict(DEVICE_TYPES)


def test_a_base_stores_its_last_command(log):
    base = Base(log["move"])
    assert base.speed == (0.0, 0.0)
    base.move(40, -15)
    assert base.speed == (40.0, -15.0)
    base.stop()
    assert base.speed == (0.0, 0.0)
    assert list(log) == [("move", 40.0, -15.0), ("move", 0.0, 0.0)]


def test_a_failed_command_is_not_stored():
    def fail(adv, rot):
        raise OSError

    base = Base(fail)
    with pytest.raises(OSError):  # noqa: PT011 - the driver's own
        base.move(1, 2)
    assert base.speed == (0.0, 0.0)


@pytest.mark.parametrize(
    ("adv", "rot", "name", "value"),
    [
        ("fast", 0, "adv", "'fast'"),
        (0, None, "rot", "None"),
        (True, 0, "adv", "True"),
        (math.nan, 0, "adv", "nan"),
        (0, math.inf, "rot", "inf"),
        (1j, 0, "adv", "1j"),
        (np.zeros(2), 0, "adv", "array([0., 0.])"),
        (10**400, 0, "adv", "1000"),
    ],
)
def test_an_invalid_value_is_refused_by_name(log, adv, rot, name, value):
    with pytest.raises(DeviceValueError, match=f"'{name}' must be a .*number, not ") as caught:
        Base(log["move"]).move(adv, rot)
    assert value in str(caught.value)
    assert list(log) == []


def test_an_error_about_a_huge_number_is_short():
    with pytest.raises(DeviceValueError) as caught:
        number("adv", 10**400)
    assert len(str(caught.value)) < 300


@pytest.mark.parametrize("value", [3, 3.0, Fraction(3), Decimal(3), np.float32(3), np.int8(3)])
def test_every_kind_of_number_is_a_number(value):
    assert type(number("x", value)) is float
    assert number("x", value) == 3.0


def test_whole_numbers_are_rounded():
    assert whole("x", 2.7) == 3


@pytest.mark.parametrize(
    ("value", "taken"), [(-1, 0), (0, 0), (128.4, 128), (255, 255), (999, 255)]
)
def test_values_out_of_range_are_clamped(value, taken):
    assert clamped("x", value, 255) == taken


def test_colours_brightness_columns_and_volumes_are_clamped(log):
    RGBLed(log["rgb"]).set_color(-5, 300, 7.6)
    matrix = Matrix(log["icon"], log["number"], log["text"])
    matrix.icon("smile", 99)
    matrix.number(1.5, -1)
    matrix.text("hi", 3, 40)
    mp3 = MP3(log["select"], log["action"], log["volume"], log["equalizer"], log["loop"])
    mp3.volume(120)
    mp3.select(1.2, 3)
    assert list(log) == [
        ("rgb", 0, 255, 8),
        ("icon", "smile", 7),
        ("number", 1.5, 0),
        ("text", "hi", 3, 15),
        ("volume", 100),
        ("select", 1, 3),
    ]


def test_a_face_stores_its_emotion_and_accepts_names(log):
    display = Display(log["show"])
    display.show_emotion(Emotion.JOY)
    display.show_emotion("fear")
    assert display.emotion is Emotion.FEAR
    assert list(log) == [("show", "joy"), ("show", "fear")]


def test_an_unknown_emotion_is_refused_with_a_suggestion(log):
    with pytest.raises(DeviceValueError) as caught:
        Display(log["show"]).show_emotion("joi")
    assert caught.value.phrase == Phrase(
        "device-unknown-emotion-like", emotion="'joi'", suggestion="joy"
    )


def test_an_emotion_like_no_other_is_refused_with_the_known_ones(log):
    with pytest.raises(DeviceValueError) as caught:
        Display(log["show"]).show_emotion("xyz")
    assert caught.value.phrase.code == "device-unknown-emotion"
    assert "surprise" in caught.value.phrase.values["known"]


def test_an_unsupported_function_of_a_device_returns_false(log):
    assert not Display(log["show"]).show_image(np.zeros((1, 1, 3), np.uint8))
    assert not Infrared(lambda: None).send(3)
    speaker = Speaker(say=log["say"])
    assert speaker.say("hello")
    assert not speaker.play("song")
    assert not speaker.tone(440, 100)
    assert list(log) == [("say", "hello")]


def test_missing_functions_are_not_among_a_devices_functions(log):
    assert set(Base(log["move"]).functions) == {"move"}
    assert set(Base(log["move"], lambda: (0, 0, 0)).functions) == {"move", "read"}


@pytest.mark.parametrize("kind", DEVICE_TYPES.values())
def test_any_device_can_be_rebuilt_from_its_functions_by_name(kind):
    names = {
        Base: ("move", "read"), JointMotor: ("move", "read"), Led: ("set",),
        RGBLed: ("set_color",), Display: ("show_emotion", "show_image"),
        Speaker: ("say", "play", "tone"), Matrix: ("icon", "number", "text"),
        MP3: ("select", "action", "volume", "equalizer", "loop"),
        Gyroscope: ("read", "reset"), Infrared: ("read", "send"), Camera: ("read", "detect"),
        DEVICE_TYPES["Animator"]: ("play",), Screen: ("show_text",),
        Pen: ("set", "set_color", "set_width", "clear"),
    }.get(kind, ("read",))  # fmt: skip
    device = kind(**dict.fromkeys(names, bool))
    assert kind(**device.functions).functions == device.functions


def test_a_command_calls_a_function_replaced_from_outside(log):
    gyroscope = Gyroscope(lambda: 1.0, log["reset"])
    gyroscope.functions["reset"] = log["watched"]
    gyroscope.reset()
    assert list(log) == [("watched",)]


def test_a_camera_without_a_frame_detects_nothing():
    assert Camera(lambda: None).detect("tags") is None


def test_a_camera_knows_only_its_detectors():
    assert Camera(lambda: np.zeros((9, 9, 3), np.uint8)).detect("unicorns") is None


def test_a_device_describes_itself(log):
    assert repr(Base(log["move"])) == "<Base: move>"
