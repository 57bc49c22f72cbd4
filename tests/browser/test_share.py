"""A program is shared as a link that proves its run, and the world as a picture or a film."""

import re
from xml.etree import ElementTree

import cv2
import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN

DRIVING = """\
main:
    function.drive_distance(100)
    function.turn(45)
end
"""


#: A browser that records only films of one type.
ONLY = """type => {
    MediaRecorder.isTypeSupported = (one) => one === type;
}"""


@pytest.fixture
def pupil(sit_down, server):
    pupil = sit_down(server, empty=True)
    pupil.write("blocktext", DRIVING)
    expect(pupil.blocks("lb_skill_drive_distance")).to_be_visible()
    return pupil


def saved(pupil, command, tmp_path):
    """Choose a way of sharing; return the path of the file that it saves."""
    # A film is saved when its run has ended.
    with pupil.page.expect_download(timeout=LONGEST_RUN) as started:
        pupil.share(command)
    path = tmp_path / started.value.suggested_filename
    started.value.save_as(path)
    return path


def is_colourful(frame):
    """Whether a picture has more than one colour above its caption."""
    return frame[: frame.shape[0] * 3 // 4].std() > 10


def test_a_picture_of_the_world_has_the_name_of_the_project(pupil, tmp_path):
    path = saved(pupil, "Picture of the world", tmp_path)
    picture = cv2.imread(str(path))
    assert path.stem == pupil.name_of_project()
    assert picture.shape == (720, 1280, 3)
    assert is_colourful(picture)


def test_a_film_shows_the_run_from_its_start_to_its_end(pupil, tmp_path):
    path = saved(pupil, "Film of a run", tmp_path)
    pupil.state("Ended")
    film = cv2.VideoCapture(str(path))
    frames = []
    while (frame := film.read())[0]:
        frames.append(frame[1])
    # A busy machine films fewer.
    assert len(frames) > 2
    assert is_colourful(frames[0])
    assert abs(frames[0].astype(int) - frames[-1]).max() > 50
    expect(pupil.page.locator(".filming")).to_have_count(0)


def test_a_page_to_take_home_shows_the_run_without_learnblock(pupil, browser, tmp_path):
    pupil.choose("Speed", "Fastest")
    pupil.run_to_the_end()
    path = saved(pupil, "Page to take home", tmp_path)
    context = browser.new_context(offline=True)
    page = context.new_page()
    page.goto(path.as_uri())
    expect(page.locator(".take-home-world canvas")).to_be_visible()
    expect(page.locator(".lbRunning")).to_contain_text("drive")
    context.close()


def test_a_browser_that_cannot_film_says_so_and_the_run_is_not_started(pupil):
    pupil.page.evaluate(ONLY, "none")
    pupil.share("Film of a run")
    pupil.expect_note("This browser can't make films.")
    expect(pupil.page.locator(".filming")).to_have_count(0)
    pupil.state("Ready")


def test_without_webm_the_film_is_an_mp4(pupil, tmp_path):
    if not pupil.page.evaluate("MediaRecorder.isTypeSupported('video/mp4')"):
        pytest.skip("this Chromium cannot record mp4")
    pupil.page.evaluate(ONLY, "video/mp4")
    path = saved(pupil, "Film of a run", tmp_path)
    assert path.suffix == ".mp4"
    assert cv2.VideoCapture(str(path)).read()[0]


def test_a_run_that_does_not_start_is_not_filmed(pupil):
    pupil.write("blocktext", "main:\n    unknown_word\nend\n")
    expect(pupil.page.locator("[role=tab] .count")).to_have_text("1")
    pupil.share("Film of a run")
    pupil.expect_note("The program has an error")
    expect(pupil.page.locator(".filming")).to_have_count(0)


#: Paste a text on the start page.
PASTE = """text => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    document.body.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true}));
}"""


def test_a_link_opens_in_another_learnblock_whose_run_is_the_same(pupil, sit_down, own_server):
    pupil.choose("Speed", "Fastest")
    pupil.run_to_the_end()
    pupil.page.get_by_role("banner").get_by_role("button", name="Share").click()
    dialog = pupil.dialog()
    expect(dialog.get_by_text("The same run, proved")).to_be_visible()
    address = dialog.get_by_label("Link", exact=True).input_value()
    expect(dialog.get_by_role("img", name="QR code of the link")).to_be_visible()
    other = sit_down(own_server, start=True, flat=True)
    other.page.evaluate(PASTE, address)
    expect(other.blocks("lb_skill_drive_distance")).to_be_visible()
    other.choose("Speed", "Fastest")
    other.run_to_the_end()
    other.expect_note("The same run as the one that was shared.")


def save_program(pupil, tmp_path, **choices):
    """Save a picture of the program; return the path of its file."""
    pupil.share("Picture of the program")
    dialog = pupil.dialog()
    expect(dialog.get_by_label("Format")).to_be_focused()
    for label, value in choices.items():
        dialog.get_by_label(label).select_option(value)
    expect(dialog.get_by_role("img")).to_be_visible()
    with pupil.page.expect_download() as started:
        dialog.get_by_role("button", name="Save").click()
    path = tmp_path / started.value.suggested_filename
    started.value.save_as(path)
    pupil.page.keyboard.press("Escape")
    return path


def test_pictures_of_the_program_need_nothing_else_and_leave_the_page_as_it_was(pupil, tmp_path):
    spanish = save_program(pupil, tmp_path, Language="Español", Theme="Dark").read_text()
    text = " ".join(ElementTree.fromstring(spanish).itertext()).replace("\xa0", " ")  # noqa: S314
    for word in ("al pulsar Ejecutar", "function.turn(45)", "girar", "delante"):
        assert word in text
    assert set(re.findall(r'(?:href="|url\()([a-z]*):', spanish)) == {"data"}
    picture = cv2.imread(str(save_program(pupil, tmp_path, Format="PNG")), cv2.IMREAD_UNCHANGED)
    assert picture.shape[2] == 4
    assert is_colourful(picture)
    expect(pupil.blocks("lb_skill_drive_distance")).to_contain_text("forward")
    expect(pupil.page.locator("html")).to_have_attribute("data-theme", "light")


#: Opens no dialog of the browser.
PRINTED = "() => { globalThis.print = () => {}; }"


def test_a_program_is_printed_with_its_numbered_lines_beside_its_blocks(pupil):
    pupil.page.evaluate(PRINTED)
    pupil.share("Print")
    sheet = pupil.page.locator(".print-sheet")
    sheet.wait_for(state="attached")
    pupil.page.emulate_media(media="print")
    expect(sheet.get_by_role("listitem")).to_have_text(
        [line.rstrip() for line in DRIVING.splitlines()]
    )
    expect(sheet.locator("img")).not_to_have_count(0)
    expect(sheet).to_contain_text(pupil.name_of_project())
    expect(pupil.page.get_by_role("banner")).to_be_hidden()
    pupil.page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(sheet).to_have_count(0)
