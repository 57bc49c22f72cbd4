"""What LEGO Education's devices send and advertise, and which of them are one robot."""

import contextlib

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from legoeducation import rpc_message as package

from learnblock.errors import RobotConnectionError, RobotNotFoundError, SettingsError
from learnblock.robots import settings
from learnblock.robots.legoed import colours, messages, nearby
from learnblock.robots.legoed.messages import Info, KitReport, Product
from learnblock.robots.legoed.nearby import NearbyDevice, advertised
from learnblock.robots.legoed.settings import Settings
from learnblock.robots.legoed.yaw import YawCount


def notification(*items):
    data = b"".join(bytes(item.Serialize()) for item in items)
    return bytes(package.DeviceNotification(len(data), data).Serialize())


BATTERY = package.InfoDeviceNotification(80, 0)
SENSOR = package.ImuDeviceNotification(0, 0, -455, *[0] * 8)
MOTORS = [package.MotorNotification(bit, 0, 0, 0, 0, 100 * bit, -1) for bit in (1, 2)]


def test_a_report_is_read_in_the_units_of_devices():
    message = notification(BATTERY, SENSOR, *MOTORS)
    assert messages.parsed(message) == KitReport(battery=80, yaw=-45.5, left=100, right=200)


def test_what_a_newer_device_reports_besides_is_skipped():
    data = bytes(BATTERY.Serialize()) + b"\xfe\x01\x02"
    message = bytes(package.DeviceNotification(len(data), data).Serialize())
    assert messages.parsed(message) == KitReport(battery=80)


def test_the_answer_of_a_device_names_its_kind_and_its_version():
    answer = package.InfoResponse(2, 3, 0, 1, 0, 0, 1, 0, 0, 244, 513)
    info = messages.parsed(bytes(answer.Serialize()))
    assert info == Info(Product.DOUBLE_MOTOR, (2, 3, 0))
    assert messages.fits(info)


@given(st.binary(max_size=80))
def test_nonsense_is_refused_or_ignored(nonsense):
    for kind in (package.INFO_RESPONSE, package.DEVICE_NOTIFICATION):
        with contextlib.suppress(ValueError):
            answer = messages.parsed(bytes([kind]) + nonsense)
            assert isinstance(answer, Info | KitReport)
    messages.parsed(b"\xff" + nonsense)


@given(st.data())
def test_a_report_that_is_cut_off_is_refused(data):
    message = notification(BATTERY, SENSOR, *MOTORS)
    length = data.draw(st.integers(1, len(message) - 1))
    with pytest.raises(ValueError, match="incomplete"):
        messages.parsed(message[:length])


def test_a_device_advertises_its_kind_and_its_card():
    data = {messages.COMPANY: bytes([2, 1, 4, 0x63, 0x0E, 0])}
    assert advertised("AA", data, -60) == NearbyDevice(
        "AA", Product.DOUBLE_MOTOR, "azure 3683", -60
    )
    assert advertised("AA", {messages.COMPANY: bytes([2, 1, 255, 0, 0])}).card == ""
    assert advertised("AA", {messages.COMPANY: b"\x02"}) is None
    assert advertised("AA", {76: bytes(6)}) is None


@given(st.dictionaries(st.sampled_from([76, messages.COMPANY]), st.binary(max_size=12)))
def test_anything_may_be_advertised(data):
    device = advertised("AA", data)
    assert device is None or device.address == "AA"


OURS = [
    NearbyDevice("D", Product.DOUBLE_MOTOR, "azure 3683", -50),
    NearbyDevice("C", Product.COLOUR_SENSOR, "azure 3683", -60),
    NearbyDevice("M", Product.SINGLE_MOTOR, "", -40),
]
THEIRS = [
    NearbyDevice("d", Product.DOUBLE_MOTOR, "red 0007", -30),
    NearbyDevice("c", Product.COLOUR_SENSOR, "red 0007", -30),
]


@pytest.fixture
def seen(monkeypatch):
    """Let devices be nearby."""

    def see(devices):
        ordered = sorted(devices, key=lambda device: -device.strength)
        monkeypatch.setattr(nearby, "look", lambda _: ordered)

    return see


def test_the_devices_with_the_card_of_the_double_motor_are_one_robot(seen):
    seen([*OURS, *THEIRS])
    places = nearby.addresses(Settings(card="azure 3683"))
    assert places == {Product.DOUBLE_MOTOR: "D", Product.COLOUR_SENSOR: "C"}


def test_a_named_device_joins_and_an_absent_one_stays_away(seen):
    seen([*OURS, *THEIRS])
    places = nearby.addresses(Settings(address="d", motor="M", colour="none"))
    assert places == {Product.DOUBLE_MOTOR: "d", Product.SINGLE_MOTOR: "M"}


def test_the_only_double_motor_needs_no_choice(seen):
    seen(OURS)
    assert nearby.addresses(Settings())[Product.DOUBLE_MOTOR] == "D"


def test_of_several_double_motors_one_must_be_chosen(seen):
    seen([*OURS, *THEIRS])
    with pytest.raises(RobotConnectionError) as refusal:
        nearby.addresses(Settings())
    assert refusal.value.phrase.code == "legoed-several"


@pytest.mark.parametrize("chosen", [{}, {"card": "green 0001"}, {"address": "X"}])
def test_a_double_motor_that_is_not_there_is_named(seen, chosen):
    seen(OURS if chosen else [])
    with pytest.raises(RobotNotFoundError):
        nearby.addresses(Settings(**chosen))


def test_connect_shows_each_double_motor_by_its_card(seen):
    seen([*OURS, *THEIRS, NearbyDevice("E", Product.DOUBLE_MOTOR, "", -80)])
    assert list(nearby.scan(Settings(), 1.0)) == [
        {"card": "red 0007"},
        {"card": "azure 3683"},
        {"address": "E"},
    ]


def test_a_card_is_a_colour_and_four_digits(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    assert settings.load("legoed", Settings, {"card": "azure 3683"}).card == "azure 3683"
    with pytest.raises((SettingsError, msgspec.ValidationError)):
        settings.load("legoed", Settings, {"card": "pink 1"})


@pytest.mark.parametrize(
    ("colour", "shown"),
    [((0, 0, 0), (-1, 0)), ((255, 0, 0), (9, 100)), ((0, 100, 0), (6, 39)), ((9, 9, 9), (10, 4))],
)
def test_the_button_shows_the_colour_that_is_most_like_it(colour, shown):
    assert colours.nearest(colour) == shown


@given(st.lists(st.integers(-1700, 1700), min_size=1, max_size=30))
def test_turns_are_counted_beyond_half_a_turn(steps):
    turning, heading = YawCount(), 0.0
    turning.follow(0.0)
    for step in steps:
        heading += step / 10
        turning.follow((heading + 180) % 360 - 180)
    assert turning.degrees == pytest.approx(heading)
