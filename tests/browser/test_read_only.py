"""A second server on the same folder that only reads."""

import pytest
from playwright.sync_api import expect

from browser.conftest import Server
from browser.pupil import WORKSPACE

pytestmark = pytest.mark.certain

PROGRAM = 'main:\n    print("hello")\nend\n'


@pytest.fixture
def reader(own_server):
    """A server that reads beside another one."""
    server = Server(own_server.home, "--read-only")
    yield server
    assert server.stop() == 0


def test_a_page_that_only_reads_runs_programs_and_refuses_edits(sit_down, own_server, reader):
    writer = sit_down(own_server, empty=True)
    writer.write("blocktext", PROGRAM)
    writer.wait_until_saved()
    pupil = sit_down(reader)
    banner = pupil.page.get_by_role("status").filter(has_text="Read only")
    expect(banner).to_contain_text(f"process {own_server.process.pid}")
    expect(pupil.page.locator(WORKSPACE)).to_contain_text("hello")
    pupil.put_cursor("blocktext", "hello")
    pupil.page.keyboard.type("bye")
    pupil.page.keyboard.press("Control+Enter")
    expect(pupil.page.locator(".console")).to_contain_text("hello")
    pupil.picture("one")
    assert pupil.text("blocktext") == PROGRAM
