"""A brick's SSH server on this machine, which executes commands in its own folder."""

import os
import queue
import socket
import subprocess
import threading
from pathlib import Path

import paramiko
from paramiko.common import cMSG_CHANNEL_SUCCESS


class SshBrick:
    """A server that accepts one user: a context manager.

    Args:
        home: the folder of its user, whose name and password are those of every new brick.
        environment: the environment of its programs.
    """

    def __init__(self, home, environment):
        self.home, self.environment = home, environment
        self.key = paramiko.RSAKey.generate(1024)
        self.executed = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._listener.settimeout(0.05)
        self.port = self._listener.getsockname()[1]
        self._ended = threading.Event()
        self._transports = []
        self._thread = threading.Thread(target=self._serve)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *error):
        self._ended.set()
        self._thread.join()
        for transport in self._transports:
            transport.close()
        self._listener.close()

    def _serve(self):
        while not self._ended.is_set():
            try:
                connection, _ = self._listener.accept()
            except TimeoutError:
                continue
            transport = Transport(connection)
            self._transports.append(transport)
            transport.add_server_key(self.key)
            transport.set_subsystem_handler("sftp", paramiko.SFTPServer, Files, self.home)
            # With an event it does not wait here: a client that does not trust the key hangs up.
            transport.start_server(threading.Event(), Server(self))


class Transport(paramiko.Transport):
    """A connection that executes a command after it has accepted it.

    A client for which the channel is closed before that takes the command for refused.
    """

    def __init__(self, connection):
        super().__init__(connection)
        self.accepted = queue.SimpleQueue()

    def _send_user_message(self, data):
        super()._send_user_message(data)
        is_command = not self.accepted.empty()
        if is_command and data.asbytes()[:1] == cMSG_CHANNEL_SUCCESS:
            self.accepted.get().start()


class Server(paramiko.ServerInterface):
    """The permissions of a client."""

    def __init__(self, brick):
        self._brick = brick

    def check_auth_password(self, username, password):
        right = (username, password) == ("robot", "maker")
        return paramiko.AUTH_SUCCESSFUL if right else paramiko.AUTH_FAILED

    def get_allowed_auths(self, username):
        return "password"

    def check_channel_request(self, kind, chanid):
        return paramiko.OPEN_SUCCEEDED

    def check_channel_exec_request(self, channel, command):
        self._brick.executed.append(command.decode())
        thread = threading.Thread(target=self._execute, args=(channel, command))
        channel.get_transport().accepted.put(thread)
        return True

    def _execute(self, channel, command):
        finished = subprocess.run(
            ["sh", "-c", command.decode()],
            cwd=self._brick.home,
            env={**self._brick.environment, "HOME": str(self._brick.home)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            check=False,
        )
        channel.sendall(finished.stdout)
        channel.send_exit_status(finished.returncode)
        channel.close()


class Files(paramiko.SFTPServerInterface):
    """The user's folder."""

    def __init__(self, server, home):
        super().__init__(server)
        self._home = home

    def open(self, path, flags, attr):
        file = self._home / Path(path).name
        handle = paramiko.SFTPHandle(flags)
        handle.filename = str(file)
        handle.writefile = handle.readfile = os.fdopen(
            os.open(file, flags, 0o644), "r+b" if flags & os.O_RDWR else "wb"
        )
        handle.chattr = lambda attr: _chmod(file, attr)
        return handle

    def chattr(self, path, attr):
        return _chmod(self._home / Path(path).name, attr)


def _chmod(file, attr):
    file.chmod(attr.st_mode & 0o777)
    return paramiko.SFTP_OK
