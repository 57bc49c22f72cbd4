"""A second `learnblock` shows the page of the first, and hands its file over."""

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.project.files.project import Project
from learnblock.project.files.share_link import SharedProject, link_of
from learnblock.project.files.writer import FolderClaim
from learnblock.server import serve
from pages import TOKEN, serving

PROGRAM = "main:\n    function.turn_back()\nend\n"


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "projects"


@pytest.fixture
def shown(monkeypatch):
    """The addresses that the browser was given."""
    addresses = []
    monkeypatch.setattr(serve, "show_in_browser", addresses.append)
    return addresses


@pytest.fixture
def started(monkeypatch):
    """The servers that were started."""
    services = []
    monkeypatch.setattr(serve, "serve", lambda service, **_: services.append(service))
    return services


@pytest.fixture
def running(folder, monkeypatch):
    """The address of a server of the user's that has the folder."""
    monkeypatch.setenv("LEARNBLOCK_TOKEN", TOKEN)
    with FolderClaim(folder) as writer, serving(folder) as server:
        assert writer.claim()
        address = f"http://127.0.0.1:{server.port}/"
        writer.describe(address, TOKEN)
        yield address


def call(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def test_the_running_one_is_shown_in_the_browser(running, folder, shown, started):
    called = call("--projects", folder)
    assert (called.exit_code, shown, started) == (0, [f"{running}?token={TOKEN}"], [])
    assert "already running" in called.output


def test_a_file_becomes_a_project_of_the_running_one(running, folder, shown, tmp_path):
    file = tmp_path / "my square.bt"
    file.write_text(PROGRAM, "utf-8")
    for name in ("my square", "my square 2"):
        assert call("open", file, "--projects", folder).exit_code == 0
        assert shown.pop() == f"{running}?token={TOKEN}#project={name.replace(' ', '%20')}"
        assert "function.turn_back()" in (folder / f"{name}.learnblock").read_text("utf-8")


def test_a_project_of_the_folder_is_shown_in_place(running, folder, shown, tmp_path):
    (tmp_path / "mine.bt").write_text(PROGRAM, "utf-8")
    call("open", tmp_path / "mine.bt", "--projects", folder)
    call("open", folder / "mine.learnblock", "--projects", folder)
    assert shown[0] == shown[1]
    assert [path.name for path in folder.glob("*.learnblock")] == ["mine.learnblock"]


def test_without_a_browser_the_address_is_printed(running, folder, shown):
    assert f"{running}?token={TOKEN}" in call("--no-browser", "--projects", folder).output
    assert shown == []


def test_a_file_that_is_no_program_is_refused_in_words(running, folder, shown, tmp_path):
    (tmp_path / "photo.learnblock").write_text("{}", "utf-8")
    called = call("open", tmp_path / "photo.learnblock", "--projects", folder)
    assert (called.exit_code, shown) == (1, [])
    assert "photo" in called.output


def test_the_token_is_not_sent_to_an_address_that_another_user_wrote(
    running, folder, shown, monkeypatch
):
    monkeypatch.setenv("LEARNBLOCK_TOKEN", "of-another-user")
    called = call("--projects", folder)
    assert (called.exit_code, shown) == (2, [])
    assert "--take-over" in called.output


def test_one_that_does_not_answer_can_be_taken_over(folder, shown, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_TOKEN", TOKEN)
    with FolderClaim(folder) as writer:
        writer.claim()
        # Nothing listens at port 1.
        writer.describe("http://127.0.0.1:1/", TOKEN)
        called = call("--projects", folder)
    assert (called.exit_code, shown) == (2, [])
    assert "--take-over" in called.output


def test_other_rules_of_access_need_a_server_of_their_own(running, folder, shown):
    called = call("--projects", folder, "--allow-host", "robots.school")
    assert (called.exit_code, shown) == (2, [])


def test_a_link_is_opened_by_the_page_of_the_running_one(running, folder, shown, started):
    link = link_of(SharedProject(Project("turn", PROGRAM)))
    result = call("open", f"http://192.168.1.20:8421/#share={link}", "--projects", folder)
    assert result.exit_code == 0, result.output
    assert (shown, started) == ([f"{running}?token={TOKEN}#share={link}"], [])


def test_a_link_is_opened_by_the_page_of_a_new_one(folder, started):
    link = link_of(SharedProject(Project("turn", PROGRAM)))
    call("open", link, "--projects", folder)
    assert started[0].link == link


def test_a_damaged_link_is_refused_at_once(folder, started):
    result = call("open", "http://127.0.0.1/#share=1.AAAA", "--projects", folder)
    assert "damaged or cut off" in result.output
    assert started == []
