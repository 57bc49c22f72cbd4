"""Cozmo through its real driver and wire, to an emulator that drives the twin."""

import math
import os
import re
import socket
import threading
import wave

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pycozmo import audio
from pycozmo import protocol_encoder as packets

from cozmos import FastClock, cozmo
from emulated import LONG, unproven
from learnblock.devices import (
    Accelerometer,
    Animator,
    Base,
    Camera,
    Display,
    Emotion,
    GroundSensors,
    Gyroscope,
    JointMotor,
    RGBLed,
    Speaker,
)
from learnblock.emulators.cozmo.face import pixels
from learnblock.errors import (
    DeviceValueError,
    LearnBlockError,
    RobotConnectionError,
    SettingsError,
    UnknownNameError,
)
from learnblock.robots import connect, find
from learnblock.robots import settings as user_settings
from learnblock.robots.cozmo import CozmoSettings, Robot, behaviours, face, sound, units
from learnblock.robots.cozmo.camera import ReceivedPicture
from learnblock.robots.cozmo.link import batches, decoded
from learnblock.robots.cozmo.odometry import CozmoOdometry
from learnblock.skills import cozmo as skills
from learnblock.testing import LINK_CLAIMS, Fault, check_robot
from places import ROOT
from runs import run_example
from twins import emotion as emotion_of
from twins import furthest, let_pass, stands_after
from twins_time import follow
from waiting import wait_for

# What every robot promises.


def test_it_conforms():
    with cozmo(speed=FastClock.speed) as there:
        certificate = check_robot(lambda: there.robot(clock=FastClock()))
    assert unproven(certificate) == list(LINK_CLAIMS)


def test_a_link_that_fails_is_reported_as_of_every_robot():
    with cozmo(speed=FastClock.speed) as there:
        certificate = check_robot(
            lambda: there.robot(patience=1.0, clock=FastClock()),
            relay=there.wire,
            claims=LINK_CLAIMS,
        )
    assert {finding.outcome for finding in certificate.findings} == {"holds"}


def test_it_has_the_devices_of_its_twin_but_no_pen():
    assert Robot.device_names() == find("sim-cozmo").load().device_names() - {"Pen:ROBOT"}


def test_it_needs_only_an_address():
    assert CozmoSettings() == CozmoSettings(address="172.31.1.1", port=5551, patience=3.0)
    with pytest.raises(SettingsError, match="volume"):
        connect("cozmo", volume=101)


def test_it_connects_and_drives_over_a_slow_link():
    with cozmo() as there:
        there.wire.fault = Fault.SLOW
        with there.robot() as robot:
            robot.device(Base).move(100, 0)
            wait_for(lambda: there.speed() > 50, "it drives")
            robot.check_link()


# The paper's programs.

#: The allowed distance in mm from the twin's path in lock-step, while time runs fast
#: on a busy machine. In real time it was 8 mm.
TOLERANCE = 60
PAPERS = [("square.bt", "empty", 80, 2.0), ("tags.bt", "tags", 26, 2.0)]


@pytest.mark.spread
@pytest.mark.parametrize(("name", "world", "seconds", "speed"), PAPERS)
def test_the_papers_programs_drive_it_like_its_twin(name, world, seconds, speed, monkeypatch):
    own = run_example(name, "sim-cozmo", world=world, seconds=seconds)
    with cozmo(world, speed=speed) as there:
        follow(there.twin, monkeypatch)
        there.is_default()
        finished = run_example(name, "cozmo", seconds=seconds)
        path = [pose for _, pose in there.twin.path]
        reached = {goal for goal, is_reached in there.twin.goals().items() if is_reached}
    assert finished.report.error is None
    assert finished.report.ended == own.report.ended
    # In an endless program, there may be time for one more.
    assert finished.report.emotions[: len(own.report.emotions)] == own.report.emotions
    assert tuple(there.machine.felt) == finished.report.emotions
    assert reached == {goal.name for goal in own.report.goals if goal.state == "reached"}
    of_twin = [pose for _, pose in own.recorder.path]
    assert furthest(path, of_twin) < TOLERANCE
    if own.report.ended == "finished":
        # The other run was stopped on its way.
        assert furthest(of_twin, path) < TOLERANCE


# Its devices.


@pytest.fixture(scope="module")
def pair():
    """A Cozmo and its driver."""
    with cozmo("tags") as there, there.robot() as robot:
        yield there, robot


def test_it_drives_in_mm_and_turns_in_degrees_to_the_right(pair):
    there, robot = pair
    base, gyroscope = robot.device(Base), robot.device(Gyroscope, "Z_AXIS")
    x, y, heading = there.pose()
    base.move(60, 90)
    wait_for(lambda: abs(there.pose()[2] - heading) > 60, "it turns")
    base.stop()
    wait_for(lambda: there.speed() < 1, "it stands")
    # Relative to its pose when it was connected.
    true_x, true_y, true_heading = there.pose()
    wait_for(lambda: abs(gyroscope.read() - true_heading) < 1, "the gyroscope follows")
    measured = base.functions["read"]()
    assert measured == pytest.approx((true_x - x, true_y - y, true_heading - heading), abs=1)
    assert true_heading > heading
    assert true_y < y
    gyroscope.reset()
    assert gyroscope.read() == 0


def test_its_accelerometer_reads_1_g_upwards(pair):
    there, robot = pair
    wait_for(lambda: there.speed() < 1, "it stands")
    wait_for(
        lambda: np.allclose(robot.device(Accelerometer).read(), (0, 0, 9.81), atol=0.5), "it rests"
    )


def test_it_feels_that_it_is_tilted_and_shaken(pair):
    there, robot = pair
    with there.twin.body() as body:
        body.hand.move("left")
    wait_for(lambda: robot.is_tilted("left"), "it is tilted")
    with there.twin.body() as body:
        body.hand.move("level")
        body.hand.move("shake")
    wait_for(robot.is_shaken, "it is shaken")
    wait_for(lambda: not robot.is_shaken() and not robot.is_tilted(), "it is left alone")


@pytest.mark.parametrize("degrees", [-25, 0, 30, 44.5])
def test_its_head_goes_to_an_angle(pair, degrees):
    there, robot = pair
    joint = robot.device(JointMotor, "CAMERA")
    joint.move(degrees)
    wait_for(lambda: abs(joint.functions["read"]() - degrees) < 0.1, "it is there")
    with there.twin.body() as body:
        assert body.joint("CAMERA") == pytest.approx(degrees, abs=0.01)


@pytest.mark.parametrize(("degrees", "height"), [(-11.36, 32), (0, 45), (30, 78), (80, 92)])
def test_its_lift_goes_to_the_height_of_its_arms_angle(pair, degrees, height):
    there, robot = pair
    robot.device(JointMotor, "ARM").move(degrees)
    assert units.lift_height(degrees) == pytest.approx(height, abs=0.01)
    expected = math.degrees(math.asin((height - 45) / 66))
    wait_for(lambda: abs(_arm(there) - expected) < 0.1, "it is there")


def _arm(there):
    with there.twin.body() as body:
        return body.joint("ARM")


@pytest.mark.parametrize("emotion", list(Emotion))
def test_its_screen_shows_each_emotion(pair, emotion):
    there, robot = pair
    robot.device(Display).show_emotion(emotion)
    wait_for(lambda: emotion_of(there.twin) == emotion.value, f"it shows {emotion}")


def test_its_screen_shows_the_emotion_with_which_a_program_ends():
    with cozmo() as there:
        with there.robot() as robot:
            robot.expressSurprise()
            robot.expressJoy()
        wait_for(lambda: emotion_of(there.twin) == "joy", "it shows joy")


def test_its_screen_shows_a_text_and_then_its_face_again(pair):
    there, robot = pair
    robot.device(Display).show_emotion(Emotion.JOY)
    wait_for(lambda: emotion_of(there.twin) == "joy", "it shows joy")
    robot.show_text("¡Hola!")
    wait_for(lambda: ("Display", "image") in _noted(there), "it is shown")
    robot.expressSadness()
    wait_for(lambda: emotion_of(there.twin) == "sadness", "it shows sadness")
    robot.show_number(7)
    robot.clear_screen()
    wait_for(lambda: emotion_of(there.twin) == "sadness", "it shows sadness again")


@pytest.mark.parametrize("text", ["7", "¡Hola!", "W" * 100, "word " * 20, "one\ntwo", "名" * 99])
def test_any_text_fits_on_its_screen_and_into_a_frame(text):
    coded = face.text(text)
    assert len(coded) <= face.LONGEST
    assert pixels(coded).any()


def test_its_screen_shows_any_picture_in_one_frame(pair):
    there, robot = pair
    noise = np.random.default_rng(0).integers(0, 256, (240, 320, 3), np.uint8)
    assert len(face.picture(noise)) <= face.LONGEST
    robot.device(Display).show_image(noise)
    wait_for(lambda: ("Display", "image") in _noted(there), "it is shown")


def _noted(there):
    with there.twin.body() as body:
        return {(entry.device, entry.action) for entry in body.log}


@pytest.mark.parametrize("slot", ["Left", "Front", "Center", "Rear", "Right"])
def test_each_lamp_has_its_own_colour(pair, slot):
    there, robot = pair
    colour = {"Left": 40, "Front": 80, "Center": 120, "Rear": 160, "Right": 255}[slot]
    robot.device(RGBLed, slot).set_color(colour, 0, 255)
    # Five bits of each colour are sent.
    wait_for(lambda: abs(_led(there, slot)[0] - colour) <= 8, "it is lit")
    assert _led(there, slot)[1:] == (0, 255)


def _led(there, slot):
    with there.twin.body() as body:
        return body.leds[slot]


@pytest.mark.parametrize("colour", [True, False])
def test_its_camera_sees_what_the_twin_sees(colour):
    with cozmo("tags") as there, there.robot(colour=colour) as robot:
        camera = robot.device(Camera)
        assert camera.read() is not None
        # Between two of these reads the next picture may arrive.
        assert any(camera.read() is camera.read() for _ in range(10))
        with there.twin.body() as body:
            truth = body.frame()
        seen = camera.read()
        # There are no pictures yet.
        assert seen.shape == (240, 320, 3)
        assert not seen.flags.writeable
        expected = truth if colour else np.repeat(truth.mean(axis=2)[..., None], 3, axis=2)
        assert np.abs(seen.astype(float) - expected).mean() < 12


TABLE = """
title = "A table"
[floor]
size = [300, 300]
border = 0
[[start]]
x = 80
y = 0
heading = 0
"""


def test_it_stops_at_a_cliff_and_reports_it(tmp_path):
    (tmp_path / "table.toml").write_text(TABLE)
    with cozmo(str(tmp_path / "table.toml")) as there, there.robot() as robot:
        ground = robot.device(GroundSensors)
        assert ground.read() == {"left": None, "central": 100.0, "right": None}
        robot.device(Base).move(100, 0)
        wait_for(lambda: ground.read()["central"] == 0, "it meets the edge")
        wait_for(lambda: there.speed() < 1, "it stands")
        robot.device(Base).move(-100, 0)
        wait_for(lambda: ground.read()["central"] == 100, "it backs away")


# Sounds.


@pytest.fixture
def quiet_pair(pair):
    """A Cozmo that has played nothing yet, and its driver."""
    there, robot = pair
    there.machine.heard.clear()
    return there, robot


def test_a_tone_arrives_as_it_was_made(quiet_pair):
    there, robot = quiet_pair
    robot.device(Speaker).tone(440, 200)
    expected = sound.packed(sound.tone(440, 0.2))
    wait_for(lambda: len(there.machine.heard) >= len(expected), "it is heard")
    assert list(there.machine.heard) == expected


@pytest.mark.skipif(not sound.can_speak(), reason="apt-get install espeak-ng")
def test_it_speaks_in_the_voice_of_its_settings(quiet_pair):
    there, robot = quiet_pair
    assert robot.device(Speaker).say("-h is no option")
    wait_for(lambda: len(there.machine.heard) > 20, "it is heard")
    with pytest.raises(LearnBlockError, match="espeak-ng can't use the voice 'xx'"):
        sound.speech("hello", "xx")


def test_without_espeak_it_does_not_speak(monkeypatch):
    monkeypatch.setattr("learnblock.robots.cozmo.sound.can_speak", lambda: False)
    with cozmo() as there, there.robot() as robot:
        assert robot.device(Speaker).say("hello") is False


def test_it_plays_notes_and_the_users_own_files(own_home):
    folder = own_home / "sounds"
    folder.mkdir()
    with wave.open(str(folder / "beep.wav"), "wb") as file:
        file.setparams((2, 2, 44100, 0, "NONE", ""))
        file.writeframes(np.tile(np.array([[1000, 3000]], "<i2"), (44100, 1)).tobytes())
    assert len(sound.named("Do")) == pytest.approx(sound.RATE / 2, abs=1)
    assert len(sound.named("beep")) == sound.RATE
    assert set(sound.named("beep").tolist()) == {2000}
    (folder / "broken.wav").write_bytes(b"RIFF")
    with pytest.raises(DeviceValueError, match=r"broken\.wav can't be played"):
        sound.named("broken")
    with pytest.raises(DeviceValueError, match=r"no sound 'beeb'\. Did you mean 'beep'"):
        sound.named("beeb")


@given(st.lists(st.integers(-32768, 32767), min_size=1, max_size=50))
def test_sounds_are_encoded_as_pycozmo_encodes_them(samples):
    coded = sound.packed(np.array(samples, np.int16))[0]
    expected = [min(audio.u_law_encoding(sample), 255) for sample in samples]
    assert list(coded[: len(samples)]) == expected


def test_every_behaviour_of_the_skills_is_there_and_ends_where_it_began():
    names = {name.removeprefix("cozmo") for name in vars(skills) if name.startswith("cozmo")}
    assert set(behaviours.BEHAVIOURS) == names
    for name, steps in behaviours.BEHAVIOURS.items():
        speeds, driven, turned = (0.0, 0.0), 0.0, 0.0
        for step in steps:
            speeds = step.drive or speeds
            driven += speeds[0] * step.seconds
            turned += speeds[1] * step.seconds
        assert (round(driven, 6), round(turned, 6), speeds) == (0, 0, (0.0, 0.0)), name


def test_a_behaviour_moves_it_until_the_program_drives_itself(quiet_pair):
    there, robot = quiet_pair
    there.machine.received.clear()
    robot.device(Animator).play("Dances")
    wait_for(lambda: there.machine.received["DriveWheels"] >= 2, "it dances")
    robot.device(Base).move(0, 0)
    counted = there.machine.received["OutputSilence"]
    wait_for(lambda: there.machine.received["OutputSilence"] > counted + 30, "it is over")
    assert there.machine.received["DriveWheels"] <= 4
    assert there.speed() < 1
    with pytest.raises(UnknownNameError, match="no behaviour 'Fly'"):
        robot.device(Animator).play("Fly")


# A wire that loses packets.


@pytest.mark.parametrize("loss", [0.0, 0.02, 0.1, 0.2])
def test_despite_losses_all_sounds_and_commands_arrive_once_and_in_order(loss, capsys):
    with cozmo(loss=loss) as there, there.robot() as robot:
        robot.device(Speaker).tone(440, 1000)
        expected = sound.packed(sound.tone(440, 1.0))
        for angle in range(100):
            robot.device(JointMotor, "CAMERA").move(angle / 4)
        wait_for(lambda: len(there.machine.heard) >= len(expected), "the sound")
        wait_for(lambda: there.machine.received["SetHeadAngle"] >= 100, "the moves")
        lost, passed = there.wire.lost, there.machine.received.total()
        assert list(there.machine.heard) == expected
        assert there.machine.received["SetHeadAngle"] == 100
        wait_for(lambda: round(_head(there), 2) == 24.75, "the last one is the last")
    counts = f"{loss:.0%} lost: {len(expected)} frames of sound and 100 moves arrived"
    with capsys.disabled():
        print(f"\n{counts} in {passed} packets; {lost} datagrams lost")  # noqa: T201 - a count


def _head(there):
    with there.twin.body() as body:
        return body.joint("CAMERA")


def test_a_cut_of_a_third_of_a_second_is_bridged():
    with cozmo() as there, there.robot() as robot:
        robot.device(Speaker).tone(440, 600)
        expected = sound.packed(sound.tone(440, 0.6))
        wait_for(lambda: len(there.machine.heard) > 5, "it is heard")
        there.wire.fault = Fault.CUT
        robot.device(Base).move(80, 0)
        let_pass(there.twin, 0.3)
        assert there.speed() < 1
        there.wire.fault = Fault.NONE
        wait_for(lambda: there.speed() > 40, "it drives")
        wait_for(lambda: len(there.machine.heard) >= len(expected), "all is heard")
        assert list(there.machine.heard) == expected
        robot.check_link()


# Robots that do not answer.


def test_a_robot_that_never_answers_is_reported_and_leaves_no_thread():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.bind(("127.0.0.1", 0))
        threads = threading.active_count()
        with pytest.raises(RobotConnectionError, match="Can't reach Cozmo at 127"):
            connect("cozmo", address="127.0.0.1", port=silent.getsockname()[1], patience=0.5)
    assert threading.active_count() == threads


def test_a_wrong_port_and_an_impossible_address_are_reported():
    with pytest.raises(RobotConnectionError, match="Can't reach Cozmo at"):
        connect("cozmo", address="127.0.0.1", port=9, patience=0.3)
    with pytest.raises(RobotConnectionError, match=r"Cozmo not found at 'no\.\.name'"):
        connect("cozmo", address="no..name")


def test_a_robot_taken_over_by_another_program_stops_and_the_first_program_gets_an_error():
    with cozmo() as there, there.robot(patience=2) as first:
        first.device(Base).move(80, 0)
        wait_for(lambda: there.speed() > 40, "it drives")
        with there.robot() as second:
            wait_for(lambda: there.speed() < 1, "it stands")
            with pytest.raises(RobotConnectionError, match="not in use by another program"):
                wait_for(first.check_link, "it is told")
            second.device(Base).move(0, 45)
            second.check_link()


def test_a_scan_finds_the_robot_of_the_settings_and_does_not_wait_for_others():
    with cozmo() as there:
        there.is_default()
        # Longer than the test may take: it does not wait that long.
        assert list(Robot.scan(1000)) == [{"address": "127.0.0.1", "port": there.port}]
        # Starting the driver would calibrate head and lift.
        assert there.machine.received.keys() <= {"Connect", "Disconnect"}
        there.wire.fault = Fault.CUT
        assert list(Robot.scan(0.3)) == []


def test_looking_for_a_robot_that_a_program_here_uses_does_not_disturb_it():
    with cozmo() as there:
        there.is_default()
        with there.robot():
            assert list(Robot.scan(0.3)) == []
            assert Robot.is_in_use()
            assert there.machine.received["Disconnect"] == 0
        assert not Robot.is_in_use()
        assert list(Robot.scan(1000)) != []


def test_the_time_from_a_ping_to_its_answer_is_known():
    with cozmo() as there, there.robot() as robot:
        wait_for(lambda: robot.status().round_trip is not None, "an answer")
        assert 0 < robot.status().round_trip < LONG


@pytest.mark.parametrize("loss", [0.0, 0.2])
def test_a_robot_whose_program_is_gone_can_be_halted(loss):
    with cozmo(loss=loss) as there, there.robot() as robot:
        robot.device(Base).move(80, 0)
        wait_for(lambda: there.speed() > 40, "it drives")
        Robot.halt(robot.settings)
        assert stands_after(there.twin) < 0.5
        assert there.machine.received["StopAllMotors"] == 1
        there.wire.fault = Fault.CUT
        with pytest.raises(RobotConnectionError, match="Can't reach Cozmo"):
            Robot.halt(CozmoSettings(address="127.0.0.1", port=there.port, patience=0.2))
        there.wire.fault = Fault.NONE


# Decoders.


@given(st.binary(max_size=200))
def test_no_datagram_brings_the_driver_down(tail):
    for head in (b"", b"COZ\x03RE\x01", b"COZ\x03RE\x01\x09"):
        decoded(head + tail)


@given(st.binary(min_size=1, max_size=400), st.sampled_from([6, 7, 8]))
def test_a_damaged_picture_is_decoded_as_none(data, encoding):
    resolution = packets.ImageResolution.QVGA
    frame = ReceivedPicture(data, packets.ImageEncoding(encoding), resolution).frame()
    assert frame is None or frame.shape == (240, 320, 3)


# Units and signs.


@pytest.mark.parametrize(
    ("adv", "rot", "left", "right"),
    [
        (100, 0, 100, 100),
        (-50, 0, -50, -50),
        (0, 180 / math.pi, 22.5, -22.5),
        (300, 0, 200, 200),
        (300, 360 / math.pi * 20 / 3, 200, 0),
    ],
)
def test_speeds_of_the_treads(adv, rot, left, right):
    assert units.treads(adv, rot) == pytest.approx((left, right), abs=1e-9)


@given(st.floats(-1e300, 1e300), st.floats(-1e300, 1e300))
def test_treads_never_exceed_their_top_speed(adv, rot):
    assert max(map(abs, units.treads(adv, rot))) <= units.MAXIMUM_SPEED * (1 + 1e-9)


def test_heads_and_lifts_stay_within_their_ranges():
    assert units.head_angle(90) == math.radians(44.5)
    assert units.head_angle(-90) == math.radians(-25)
    assert units.lift_height(90) == 92
    assert units.lift_height(-90) == 32
    assert units.lift_angle(units.lift_height(20)) == pytest.approx(20)


def test_the_robots_accelerations_are_mm_per_s2():
    assert units.acceleration(0, -500, 9810) == (0, -0.5, 9.81)


def test_odometry_counts_full_turns_to_the_right_and_accepts_a_new_origin():
    odometry = CozmoOdometry()
    for degrees in range(0, 801, 20):
        odometry.follow((0, 1), 10, 20, math.remainder(-math.radians(degrees), 2 * math.pi))
    assert odometry.turned() == pytest.approx(800)
    assert odometry.pose == pytest.approx((10, 20, 80))
    odometry.follow((1, 2), 0, 0, 0)
    assert odometry.turned() == pytest.approx(800)
    odometry.follow((1, 2), 0, 0, math.radians(30))
    assert odometry.turned() == pytest.approx(770)
    odometry.reset()
    assert odometry.turned() == 0


def test_packets_are_split_where_a_frame_is_full():
    numbered = [(number, packets.OutputAudio(samples=bytes(744))) for number in range(3)]
    numbered.append((3, packets.OutputSilence()))
    assert [[number for number, _ in batch] for batch in batches(numbered)] == [[0], [1], [2, 3]]


def test_no_thread_and_no_process_is_left():
    threads = threading.active_count()
    with cozmo() as there, there.robot() as robot:
        guardian = robot._guardian._process.pid
    assert threading.active_count() == threads
    with pytest.raises(ProcessLookupError):
        os.kill(guardian, 0)


# Its page.

PAGE = (ROOT / "docs" / "robots" / "cozmo.md").read_text()


def test_the_page_names_every_setting_with_its_default():
    rows = dict(re.findall(r"^\| `(\w+)` \| (?:`(.*?)`)? ?\|", PAGE, re.M))
    defaults = {one.name: one.default for one in user_settings.describe("cozmo", CozmoSettings)}
    assert rows.keys() == defaults.keys()
    texts = {name: str(value).lower() for name, value in defaults.items()}
    assert rows == texts


def test_the_page_names_every_device():
    kinds = {name.partition(":")[0] for name in Robot.device_names()}
    assert set(re.findall(r"^\| `(\w+):", PAGE, re.M)) == kinds


def test_the_pages_program_drives_a_cozmo(capsys):
    exec(re.search("```python\n(.*?)```", PAGE, re.S)[1], {})  # noqa: S102 - our own
    x, y, heading = eval(capsys.readouterr().out)  # noqa: S307 - our own
    # 50 in a second of real time; a busy machine sends the first command late.
    assert 5 < x < 90
    assert (round(y), round(heading)) == (0, 0)
