"""The page's address: that of this computer, and the token, which survives restarts."""

import ipaddress
import socket
import stat

import pytest

from learnblock.errors import LearnBlockError
from learnblock.server.http.address import VARIABLE, own_address, token


@pytest.fixture(autouse=True)
def no_chosen_token(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)


def test_a_user_has_one_token_until_a_new_one_is_asked_for():
    first = token()
    assert token() == first
    second = token(new=True)
    assert second != first
    assert token() == second


def test_the_token_in_the_environment_is_used_and_not_saved(monkeypatch):
    monkeypatch.setenv(VARIABLE, "of-the-hub")
    assert token() == "of-the-hub"
    monkeypatch.delenv(VARIABLE)
    assert token() != "of-the-hub"


def test_only_its_owner_can_read_it(own_home):
    token()
    assert stat.S_IMODE((own_home / "token").stat().st_mode) == 0o600


@pytest.mark.parametrize("text", ["", "two words", "x" * 201, "\xe9"])
def test_a_damaged_file_is_replaced(own_home, text):
    (own_home / "token").write_text(text, "utf-8")
    (own_home / "token").chmod(0o600)
    assert token() == token() != text


def test_a_token_that_others_could_read_is_replaced(own_home):
    first = token()
    (own_home / "token").chmod(0o644)
    assert token() != first


def test_where_nothing_can_be_saved_there_is_a_token_for_once(monkeypatch, tmp_path):
    (tmp_path / "file").touch()
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "file"))
    assert token() != token()


def test_a_token_that_no_address_can_hold_is_refused(monkeypatch):
    monkeypatch.setenv(VARIABLE, "not a token")
    with pytest.raises(LearnBlockError, match=VARIABLE):
        token()


def test_the_own_address_belongs_to_this_computer():
    address = own_address()
    if address is not None:
        with socket.socket() as listening:
            listening.bind((str(ipaddress.ip_address(address)), 0))


def test_a_computer_without_a_network_has_no_address(monkeypatch):
    class Unreachable(socket.socket):
        def connect(self, address):
            raise OSError("Network is unreachable")

    monkeypatch.setattr(socket, "socket", Unreachable)
    assert own_address() is None
