"""The address by which other devices reach this computer."""

import ipaddress
import socket

from learnblock.server.http import own_address as module
from learnblock.server.http.own_address import own_address


def test_the_own_address_belongs_to_this_computer():
    address = own_address()
    if address is not None:
        with socket.socket() as listening:
            listening.bind((str(ipaddress.ip_address(address)), 0))


def test_a_computer_without_a_network_has_no_address(monkeypatch):
    class Unreachable(socket.socket):
        def connect(self, address):
            raise OSError("Network is unreachable")

    monkeypatch.setattr(module.socket, "socket", Unreachable)
    assert own_address() is None
