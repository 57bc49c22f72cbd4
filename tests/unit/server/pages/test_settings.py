"""Messages between page and server about robot settings and camera recognition."""

import tomllib

import pytest

from pages import english


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def read(page, robot=""):
    page.say("ReadSettings", robot=robot)
    return {one["name"]: one for one in page.hear("SettingsTable", robot=robot)["settings"]}


def change(page, robot="", **values):
    page.say("ChangeSettings", robot=robot, values=values)
    return page.hear("SettingsTable", robot=robot)


def saved(own_home):
    file = own_home / "settings.toml"
    return tomllib.loads(file.read_text("utf-8")) if file.exists() else {}


def test_each_setting_has_its_allowed_values(page):
    settings = read(page, "ev3")
    assert (settings["ssh_port"]["sort"], settings["ssh_port"]["most"]) == ("whole", 65535)
    assert (settings["wheel_radius"]["sort"], settings["wheel_radius"]["least"]) == ("number", 1)
    assert settings["left"]["choices"] == ["A", "B", "C", "D"]
    assert (settings["address"]["sort"], settings["address"]["default"]) == ("text", "ev3dev.local")
    assert [name for name, one in settings.items() if one.get("secret")] == ["token", "password"]
    assert read(page, "rcis")["laser_ports"]["sort"] == "list"
    webcam = read(page)["webcam"]
    assert (webcam["sort"], webcam["choices"], webcam["value"]) == ("whole", ["none"], "none")


def test_several_settings_are_changed_at_once_and_restored(page, own_home):
    told = change(page, "cozmo", address="192.168.1.20", volume=30)
    assert {one["name"]: one["value"] for one in told["settings"]}["volume"] == 30
    assert saved(own_home) == {"robots": {"cozmo": {"address": "192.168.1.20", "volume": 30}}}
    change(page, "cozmo", address=None)
    assert saved(own_home) == {"robots": {"cozmo": {"volume": 30}}}


def test_one_invalid_value_prevents_all_changes(page, own_home):
    told = change(page, "cozmo", address="192.168.1.20", volume=300, port="many", height=3)
    assert told["wrong"].keys() == {"volume", "port", "height"}
    assert "must be a whole number from 0 to 100" in english(told["wrong"]["volume"])
    assert saved(own_home) == {}


def test_a_mistake_in_the_file_is_reported_with_its_line(page, own_home):
    (own_home / "settings.toml").write_text("[robots.cozmo]\nvolume = 300\n")
    page.say("ReadSettings", robot="cozmo")
    assert english(page.hear("SettingsTable")["problem"]).startswith(
        "Line 2: 'robots.cozmo.volume' is 300"
    )


def test_emotions_on_cameras_need_consent(page, own_home):
    page.say("ChangeSettings", robot="", values={"emotions_on_cameras": True})
    assert "agree to it first" in english(page.hear("Failed")["message"])
    page.say("ChangeSettings", robot="", values={"emotions_on_cameras": True}, agreed=True)
    page.hear("SettingsTable")
    assert saved(own_home) == {"perception": {"emotions_on_cameras": True}}


@pytest.mark.parametrize("name", ["../settings.toml", "/etc/passwd", "nothing.avi", "..", "."])
def test_a_page_can_choose_only_videos_in_their_folder(name, page, own_home):
    (own_home / "videos").mkdir()
    page.say("ChangeSettings", robot="", values={"video": name})
    assert "There is no video" in english(page.hear("Failed")["message"])
    assert saved(own_home) == {}


def test_a_video_in_its_folder_can_be_chosen(page, own_home):
    (own_home / "videos").mkdir()
    video = own_home / "videos" / "walk.avi"
    video.write_bytes(b"RIFF")
    change(page, video="walk.avi")
    assert saved(own_home) == {"perception": {"video": str(video)}}
    change(page, video="")
    assert saved(own_home)["perception"] == {}


@pytest.mark.parametrize("device", ["/etc/passwd", "/dev/../etc/passwd", "x", 3, "/dev/"])
def test_a_page_cannot_choose_a_file_as_a_device(device, page, own_home):
    page.say("ChangeSettings", robot="ev3", values={"device": device})
    assert "is not a device" in english(page.hear("Failed")["message"])
    assert saved(own_home) == {}


@pytest.mark.parametrize("robot", ["sim-ebo", "nobody", "../x"])
def test_a_robot_without_settings_is_refused(robot, page):
    page.say("ReadSettings", robot=robot)
    assert robot in english(page.hear("Failed")["message"])
