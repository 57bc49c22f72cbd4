"""A project is opened on another device, and the page is installed as an app."""

import json

import cv2
import numpy as np
import pytest
from playwright.sync_api import expect

from browser.conftest import Server

LOOPBACK = "127.0.0.1"


@pytest.fixture
def open_server(tmp_path):
    """A server that other devices can use."""
    server = Server(tmp_path / "home", "--host=0.0.0.0")
    server.address = f"http://{LOOPBACK}:{server.port}/?{server.address.partition('?')[2]}"
    yield server
    server.stop()


def show(pupil):
    pupil.command("Settings and help", "Open on another device…")
    return pupil.dialog()


def scanned(picture):
    """Return the text of the QR code in a picture of the page."""
    image = cv2.imdecode(np.frombuffer(picture.screenshot(), np.uint8), cv2.IMREAD_COLOR)
    text, _, _ = cv2.QRCodeDetector().detectAndDecode(image)
    return text


def test_the_code_opens_the_project_on_another_device_and_both_show_each_edit(
    sit_down, open_server, browser
):
    pupil = sit_down(open_server, empty=True)
    dialog = show(pupil)
    code = dialog.get_by_role("img", name="QR code of the address of this project")
    expect(code).to_be_visible()
    pupil.picture("code")
    address = scanned(code)
    assert address == dialog.get_by_label("Address").input_value()
    assert LOOPBACK not in address
    pupil.page.keyboard.press("Escape")
    tablet = browser.new_context(viewport={"width": 820, "height": 1180}, has_touch=True).new_page()
    tablet.goto(address)
    expect(tablet.locator("header .project-name")).to_have_text(pupil.name_of_project())
    pupil.write("blocktext", "main:\n    function.sleep(7)\nend\n")
    expect(tablet.locator(".lb_skill_sleep")).to_be_visible()
    tablet.context.close()


def test_a_server_for_this_computer_alone_says_how_to_open_it_to_others(sit_down, server):
    pupil = sit_down(server)
    dialog = show(pupil)
    expect(dialog).to_contain_text("Only this computer can open the page.")
    expect(dialog.locator("pre")).to_have_text("learnblock --host 0.0.0.0")
    expect(dialog.get_by_role("img")).to_have_count(0)


def test_the_page_can_be_installed_and_says_when_the_server_is_gone(sit_down, own_server):
    pupil = sit_down(own_server)
    page = pupil.page
    page.evaluate("() => navigator.serviceWorker.ready.then(() => true)")
    manifest = page.request.get(page.evaluate("document.querySelector('[rel=manifest]').href"))
    icons = json.loads(manifest.body())["icons"]
    assert {icon["sizes"] for icon in icons} >= {"192x192", "512x512"}
    for icon in icons:
        assert page.request.get(f"{page.url.split('#')[0]}{icon['src']}").ok
    own_server.kill()
    page.reload()
    expect(page.get_by_role("heading")).to_have_text("LearnBlock is not running")
    own_server.start()
    page.get_by_role("link").click()
    expect(page.get_by_role("heading", name="My projects")).to_be_visible()
