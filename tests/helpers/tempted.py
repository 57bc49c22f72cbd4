"""A robot whose driver does whatever a program says, and what bad programs say to it."""

import ctypes
import os
from collections.abc import Callable, Mapping
from typing import ClassVar

from learnblock.client import Client, Rights
from learnblock.devices import Base, Speaker
from learnblock.robots import RobotEntry
from learnblock.running import Job, ProgramRun, Report
from learnblock.runtime.limits import Limits
from learnblock.runtime.program import Program

#: Numbers of system calls on x86-64.
_CALL = "libc.syscall.restype = ctypes.c_long\nchecked(libc.syscall({0}))"

#: What each of them tries, in Python; FOLDER holds the user's files.
WRITING = {
    "make a file": "open(FOLDER + '/new.txt', 'w').close()",
    "empty a file": "open(FOLDER + '/emptied.txt', 'w').close()",
    "change a file": "open(FOLDER + '/emptied.txt', 'r+').close()",
    "append to a file": "open(FOLDER + '/.bashrc', 'a').close()",
    "cut a file short": "os.truncate(FOLDER + '/emptied.txt', 1)",
    "remove a file": "os.unlink(FOLDER + '/removed.txt')",
    "rename a file": "os.rename(FOLDER + '/moved.txt', FOLDER + '/gone.txt')",
    "move a file away": "os.rename(FOLDER + '/.bashrc', FOLDER + '/empty/gone.txt')",
    "make a folder": "os.mkdir(FOLDER + '/folder')",
    "remove a folder": "os.rmdir(FOLDER + '/bare')",
    "make a symbolic link": "os.symlink('/etc', FOLDER + '/link')",
    "make a hard link": "os.link(FOLDER + '/emptied.txt', FOLDER + '/second.txt')",
    "make a pipe with a name": "os.mkfifo(FOLDER + '/pipe')",
    "change a file's rights": "os.chmod(FOLDER + '/emptied.txt', 0o777)",
    "change a file's dates": "os.utime(FOLDER + '/emptied.txt', (0, 0))",
    "change a file's attributes": "os.setxattr(FOLDER + '/emptied.txt', 'user.a', b'b')",
    "write to shared memory": "open('/dev/shm/lb', 'w').close()\nos.unlink('/dev/shm/lb')",
    "open a terminal": "for file in os.openpty(): os.close(file)",
    "a temporary file": "tempfile.TemporaryFile().close()",
    "write in a thread of the driver": (
        "found = []\n"
        "def write():\n"
        "    try: open(FOLDER + '/new.txt', 'w').close()\n"
        "    except OSError as error: found.append(error)\n"
        "thread = threading.Thread(target=write)\nthread.start()\nthread.join()\n"
        "if found: raise found[0]"
    ),
}
STARTING = {
    "start a program": "subprocess.run(['true'])",
    "start a shell": "subprocess.run('true', shell=True)",
    "start a program as posix does": "os.waitpid(os.posix_spawn('/bin/true', ['true'], {}), 0)",
    "start a shell as C does": "checked(-1 if libc.system(b'true') else 0)",
    "become another program": "os.execv('/bin/none', ['none'])",
}
COPYING = {
    "copy the process": "os.fork() or os._exit(0)",
    "copy the process as C does": "checked(libc.fork()) or os._exit(0)",
    "copy the process by the old call": _CALL.format(57) + " or os._exit(0)",
}
CONNECTING = {
    "connect to a server": "socket.create_connection(('127.0.0.1', 1), 0.1)",
    "open a datagram socket": "socket.socket(type=socket.SOCK_DGRAM).close()",
    "be a server": "socket.create_server(('127.0.0.1', 0)).close()",
    "talk to a local service": "socket.socket(socket.AF_UNIX).close()",
    "talk to the kernel": "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW).close()",
    "open a socket as C does": "os.close(checked(libc.socket(2, 1, 0)))",
    "let the kernel connect (io_uring)": _CALL.format("425, 1, ctypes.create_string_buffer(200)"),
}


class Robot(Client):
    """A robot whose driver carries out what it should say."""

    has_extra_camera = False
    #: What the driver's code may use, and what came of each attempt.
    folder = ""
    results: ClassVar[dict[str, str]] = {}

    def connect(self) -> None:
        self.add(Base(move=lambda adv, rot: None))
        self.add(Speaker(say=self.say))

    def say(self, text: str) -> None:
        """Carry out a program: its first line is its name."""
        name, _, source = text.partition("\n")
        self.results[name] = attempt(lambda: exec(source, self.names()))  # noqa: S102 - the attack

    def names(self) -> dict[str, object]:
        modules = ("ctypes", "os", "socket", "subprocess", "tempfile", "threading")
        libc = ctypes.CDLL(None, use_errno=True)
        loaded = {name: __import__(name) for name in modules}
        return {**loaded, "libc": libc, "checked": checked, "FOLDER": self.folder}


def checked(result: int) -> int:
    if result == -1:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result


def attempt(action: Callable[[], object]) -> str:
    try:
        action()
    except OSError as error:
        return type(error).__name__
    return "IN"


def entry() -> RobotEntry:
    return RobotEntry("tempted", __name__)


def tempt(attempts: Mapping[str, str], folder: object, rights: Rights) -> dict[str, str]:
    """Let a program in its process tempt a driver with these rights; return what came of it."""
    Robot.folder, Robot.results, Robot.rights = str(folder), {}, rights
    lines = [f"robot.say_Text({name + chr(10) + source!r})" for name, source in attempts.items()]
    report = run("\n".join(lines))
    assert report.error is None, report.error
    return Robot.results


def run(source: str, limits: Limits | None = None) -> Report:
    # The run creates our robot whatever the program imports.
    text = f"from learnblock.robots.tempted import Robot\nrobot = Robot()\n{source}"
    program = Program("tempting.py", text, text)
    return ProgramRun(Job(program, entry(), limits=limits or Limits())).run()
