"""Projects of the page that the user's settings allow the network."""

import pytest

pytestmark = pytest.mark.realtime

PROGRAM = """from learnblock.robots.sim_ebo import Robot
import socket

robot = Robot()
socket.socket().close()
"""


@pytest.mark.parametrize(("allowed", "ended"), [("online", "finished"), ("other", "error")])
def test_only_a_project_named_in_the_settings_may_use_it(page, projects, own_home, allowed, ended):
    page.say("Import", filename="online.py", text=PROGRAM)
    page.hear("Document")
    named = [str(projects / f"{allowed}.learnblock")]
    (own_home / "settings.toml").write_text(f"[network]\nallowed = {named}\n", "utf-8")
    assert page.run()["ended"] == ended
