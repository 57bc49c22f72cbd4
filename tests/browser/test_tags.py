"""Tag names on the page."""

import pytest
from playwright.sync_api import expect


@pytest.fixture
def pupil(sit_down, own_server):
    pupil = sit_down(own_server)
    pupil.begin()
    pupil.project("Tag names…")
    return pupil


def test_a_named_tag_is_shown_and_suggested(pupil, own_server):
    add(pupil, "ball", "7")
    expect(pupil.dialog().get_by_role("img", name="Picture of tag 7")).to_be_visible()
    pupil.picture("one")
    save(pupil)
    assert (own_server.home / "tags.toml").read_text("utf-8") == "ball = 7\n"
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    pupil.write("blocktext", "main:\n    x = function.is_tag()\nend\n")
    pupil.put_cursor("blocktext", ")")
    pupil.page.keyboard.press("Control+Space")
    expect(pupil.page.locator(".cm-tooltip-autocomplete")).to_contain_text('"ball"')


def test_names_are_downloaded_and_uploaded_again(pupil, tmp_path):
    add(pupil, "red door", "12")
    save(pupil)
    files = [
        download(pupil, name, tmp_path)
        for name in ("Download (TOML)", "Download (CSV)", "Print tags")
    ]
    assert [file.name for file in files] == ["tags.toml", "tags.csv", "tags.html"]
    assert "12 red door</figcaption>" in files[2].read_text("utf-8")
    for file in files[:2]:
        pupil.dialog().get_by_role("button", name="Remove red door").click()
        expect(pupil.dialog().get_by_role("textbox", name="Name")).to_have_count(0)
        upload(pupil, file)
        expect(pupil.dialog().get_by_role("textbox", name="Name")).to_have_value("red door")


def add(pupil, name, number):
    pupil.dialog().get_by_role("button", name="Add a name").click()
    expect(pupil.dialog().get_by_role("textbox", name="Name").last).to_be_focused()
    pupil.page.keyboard.type(name)
    pupil.dialog().get_by_role("spinbutton").last.fill(number)


def save(pupil):
    pupil.dialog().get_by_role("button", name="Save").click()
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()


def download(pupil, button, folder):
    with pupil.page.expect_download() as started:
        pupil.dialog().get_by_role("button", name=button).click()
    file = folder / started.value.suggested_filename
    started.value.save_as(file)
    return file


def upload(pupil, file):
    with pupil.page.expect_file_chooser() as chooser:
        pupil.dialog().get_by_role("button", name="Add names from a file…").click()
    chooser.value.set_files(file)
