"""Settings of robots and of camera recognition on the page."""

import re
import tomllib

import pytest
from playwright.sync_api import expect

from emulated import settle
from learnblock.emulators import emulate

#: Types into the field for a video in the moment in which it appears.
TYPE_AT_ONCE = """() => new MutationObserver((_, watcher) => {
    const labels = [...document.querySelectorAll("dialog label")];
    const field = labels.find((one) => one.textContent.startsWith("Video"))?.control;
    if (!field) return;
    watcher.disconnect();
    field.value = "walk.avi";
    field.dispatchEvent(new InputEvent("input", { bubbles: true }));
}).observe(document, { subtree: true, childList: true })"""


@pytest.fixture
def pupil(sit_down, own_server):
    return sit_down(own_server, empty=True)


def test_robot_settings_are_saved_and_an_invalid_value_is_reported_at_its_field(pupil, own_server):
    choose(pupil, "Robot settings…")
    pupil.dialog().get_by_role("combobox", name="Robot").select_option("ev3")
    field(pupil, "Address").fill("192.168.1.7")
    field(pupil, "Maximum speed").fill("5")
    save(pupil)
    expect(pupil.dialog()).to_contain_text(re.compile("full_speed.* is 5, but must be"))
    pupil.picture("wrong")
    assert saved(own_server) == {}
    field(pupil, "Maximum speed").fill("900")
    pupil.dialog().get_by_role("combobox", name="Gyroscope").select_option("2")
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert saved(own_server)["robots"]["ev3"] == {
        "address": "192.168.1.7", "full_speed": 900, "gyroscope": "2",
    }  # fmt: skip
    pupil.dialog().get_by_role("button", name="Default").first.click()
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert "address" not in saved(own_server)["robots"]["ev3"]


def test_the_saved_settings_of_a_robot_are_tested_and_a_robot_that_is_missing_is_named(
    pupil, own_server, monkeypatch
):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_server.home))
    with emulate("ebo", "empty") as emulation:
        settle("ebo", {**emulation.settings, "patience": 15.0})
        choose(pupil, "Robot settings…")
        pupil.dialog().get_by_role("combobox", name="Robot").select_option("ebo")
        test = pupil.dialog().get_by_role("button", name="Test", exact=True)
        test.click()
        expect(pupil.dialog().get_by_text("EBO answers. Programs can use it.")).to_be_visible()
        pupil.picture("answered")
        field(pupil, "Timeout").fill("1")
        # What is tested is what programs use.
        expect(test).to_be_disabled()
        save(pupil)
    test.click()
    expect(pupil.dialog().get_by_text("Can't reach EBO's wheels at 127.0.0.1")).to_be_visible()
    pupil.picture("missing")
    # Its connection is not held: another robot can be tested.
    expect(test).to_be_enabled()


def test_emotions_on_cameras_are_switched_on_only_after_agreement(pupil, own_server):
    choose(pupil, "Camera recognition…", menu="Settings and help")
    expect(pupil.dialog()).to_contain_text("Article 5(1)(f)")
    field(pupil, "Recognise emotions on real cameras").check()
    button = pupil.dialog().get_by_role("button", name="Save")
    expect(button).to_be_disabled()
    pupil.picture("law")
    pupil.dialog().get_by_role("checkbox", name="I am an adult").check()
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert saved(own_server)["perception"] == {"emotions_on_cameras": True}


def test_a_video_must_be_in_its_folder(pupil, own_server):
    videos = own_server.home / "videos"
    videos.mkdir()
    (videos / "walk.avi").write_bytes(b"RIFF")
    choose(pupil, "Camera recognition…", menu="Settings and help")
    field(pupil, "Video").fill("../settings.toml")
    save(pupil)
    expect(pupil.dialog().get_by_role("alert")).to_contain_text("There is no video")
    field(pupil, "Video").fill("walk.avi")
    field(pupil, "Webcam").fill("1")
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert saved(own_server)["perception"] == {"video": str(videos / "walk.avi"), "webcam": 1}
    field(pupil, "Webcam").fill("")
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert "webcam" not in saved(own_server)["perception"]


@pytest.mark.certain
def test_what_is_typed_as_soon_as_a_field_appears_is_kept(pupil, own_server):
    videos = own_server.home / "videos"
    videos.mkdir()
    (videos / "walk.avi").write_bytes(b"RIFF")
    pupil.page.evaluate(TYPE_AT_ONCE)
    choose(pupil, "Camera recognition…", menu="Settings and help")
    field(pupil, "Webcam").fill("1")
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert saved(own_server)["perception"] == {"video": str(videos / "walk.avi"), "webcam": 1}


def test_in_spanish_by_keyboard(sit_down, own_server):
    pupil = sit_down(own_server, language="es", theme="dark")
    choose(pupil, "Ajustes de los robots…", menu="Robot")
    pupil.dialog().get_by_role("combobox", name="Robot").select_option("cozmo")
    field(pupil, "Volumen").focus()
    pupil.page.keyboard.press("Control+a")
    pupil.page.keyboard.type("500")
    pupil.page.keyboard.press("Enter")
    expect(pupil.dialog()).to_contain_text("un número entero de 0 a 100")
    pupil.picture("spanish")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)


def choose(pupil, item, menu="Robot"):
    pupil.menu(menu).click()
    pupil.page.get_by_role("menuitem", name=item, exact=True).click()


def field(pupil, name):
    return pupil.dialog().get_by_label(name, exact=True)


def save(pupil):
    pupil.dialog().get_by_role("button", name="Save", exact=True).click()


def saved(server):
    file = server.home / "settings.toml"
    return tomllib.loads(file.read_text("utf-8")) if file.exists() else {}
