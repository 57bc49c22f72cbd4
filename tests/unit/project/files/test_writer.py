"""The right to write to a folder of projects."""

import errno
import os
import socket
import subprocess
import sys

import msgspec
import pytest

from learnblock.project.files.writer import Access, FolderClaim, Owner

pytestmark = [pytest.mark.realtime, pytest.mark.certain]

HOLDS = """
import sys, time
from pathlib import Path
from learnblock.project.files.writer import FolderClaim

writer = FolderClaim(Path(sys.argv[1]))
assert writer.claim()
writer.describe("http://127.0.0.1:8421/", "the-token")
print("claimed", flush=True)
while not writer.is_asked_to_end:
    time.sleep(0.002)
writer.release()
"""


@pytest.fixture
def holder(tmp_path):
    """Another process with the right to write."""
    command = [sys.executable, "-c", HOLDS, str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "claimed\n"
        yield process
        process.kill()


def test_one_process_at_a_time_has_the_right_to_write(tmp_path, holder):
    with FolderClaim(tmp_path) as writer:
        assert not writer.claim()


def test_the_others_learn_who_has_it(tmp_path, holder):
    owner = FolderClaim(tmp_path).owner
    assert (owner.process, owner.computer) == (holder.pid, socket.gethostname())
    assert owner.address == "http://127.0.0.1:8421/"
    assert str(holder.pid) in str(owner.phrase)


def test_only_who_knows_the_token_can_tell_that_the_server_knows_it(tmp_path, holder):
    owner = FolderClaim(tmp_path).owner
    assert owner.knows("the-token")
    assert not owner.knows("another")
    assert not msgspec.structs.replace(owner, address="http://127.0.0.1:1/").knows("the-token")
    assert b"the-token" not in (tmp_path / ".writer.json").read_bytes()


def test_a_killed_process_is_no_obstacle(tmp_path, holder):
    holder.kill()
    holder.wait()
    with FolderClaim(tmp_path) as writer:
        assert writer.claim()
        assert writer.owner is None


def test_taking_over_asks_the_other_process_to_end_and_waits_for_it(tmp_path, holder):
    with FolderClaim(tmp_path) as writer:
        assert writer.take_over(20.0)
        assert holder.wait(20.0) == 0
        assert not writer.is_asked_to_end


def test_taking_over_ends_after_a_time_and_withdraws_its_request(tmp_path):
    with FolderClaim(tmp_path) as deaf, FolderClaim(tmp_path) as writer:
        assert deaf.claim()
        assert not writer.take_over(0.2)
        assert not deaf.is_asked_to_end


def test_a_released_folder_can_be_claimed_again(tmp_path):
    with FolderClaim(tmp_path) as one, FolderClaim(tmp_path) as two:
        assert one.claim()
        one.release()
        one.release()
        assert two.claim()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such rights")
def test_every_user_of_a_shared_folder_may_lock_it(tmp_path):
    with FolderClaim(tmp_path) as writer:
        assert writer.claim()
        assert (tmp_path / ".writer.lock").stat().st_mode & 0o777 == 0o666


def test_a_folder_without_locks_is_reported_as_such(tmp_path, monkeypatch):
    fcntl = pytest.importorskip("fcntl")

    def refused(*_):
        raise OSError(errno.ENOSYS, "Function not implemented")

    monkeypatch.setattr(fcntl, "flock", refused)
    with FolderClaim(tmp_path) as writer, pytest.raises(OSError, match="not implemented"):
        writer.claim()


@pytest.mark.parametrize(
    "wrong",
    [
        b"",
        b"[]",
        b"\xff",
        b'{"process": 1}',
        msgspec.json.encode(Owner(1, "here", 1e300, "")),
        msgspec.json.encode(Owner(1, "here", 0.0, "\x1b[2J")),
    ],
)
def test_a_damaged_description_says_nothing_about_the_owner(tmp_path, wrong):
    (tmp_path / ".writer.json").write_bytes(wrong)
    assert FolderClaim(tmp_path).owner is None


def test_the_owner_on_another_computer_is_named_with_it():
    assert "process 7 on lab-3" in str(Owner(7, "lab-3", 0.0, "http://lab-3/").phrase)


def test_reading_names_the_server_that_writes(tmp_path, holder):
    assert str(holder.pid) in str(Access.reading(FolderClaim(tmp_path)).read_only)


def test_reading_alone_names_none(tmp_path):
    assert "process" not in str(Access.reading(FolderClaim(tmp_path)).read_only)
