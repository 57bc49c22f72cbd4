"""Attacks by a pupil's program on the computer, and the program that tries them.

Each attack is a piece of Python that raises an error where it is refused, and ends well where it
gets in. It goes around Python's own refusals wherever it can, with ctypes.
"""

import json
import os
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

from learnblock import robots
from learnblock.running import Options, batch
from learnblock.running.batch import Batch, WarmProcess
from learnblock.running.job import Job
from learnblock.runtime.containment import landlock, seccomp
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Contained, Ended, Printed, Setup
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.program import Program
from learnblock.runtime.standby import Standby

_POPEN = subprocess.Popen

#: Whether this computer has all that the table expects.
COMPLETE = (
    sys.platform == "linux"
    and os.uname().machine == "x86_64"
    and landlock.version() >= 6
    and seccomp.is_supported()
)


@dataclass(frozen=True)
class Attack:
    """One attack.

    Args:
        name: what it tries.
        by: what refuses it.
        source: its Python.
    """

    name: str
    by: str
    source: str


@dataclass(frozen=True)
class Targets:
    """What the attacks aim at.

    Args:
        folder: a folder with another person's files, which are none of the program's business.
        project: the program's own folder, to read.
        victim: another process of the same user.
    """

    folder: Path
    project: Path
    victim: int

    @property
    def in_shared_folder(self) -> "Targets":
        """The same for a program whose folder has those of others in it, as a home folder has."""
        return replace(self, project=self.folder.parent)


_PRELUDE = """
import ctypes, gc, json, mmap, os, resource, signal, socket, stat, struct, sys, tempfile

libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long

def checked(result):
    if result == -1:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result

def call(number, *args):
    args = [ctypes.c_long(a) if isinstance(a, int) else a for a in args]
    return checked(libc.syscall(ctypes.c_long(number), *args))

def c(name, *args):
    return checked(getattr(libc, name)(*args))

def forked(process):
    if process == 0:
        os._exit(0)
    os.waitpid(process, 0)

def unhooked():
    for found in gc.get_objects():
        if getattr(type(found), "__name__", "") == "function" and found.__name__ == "refuse":
            found.__closure__[0].cell_contents.clear()

class Refused(Exception):
    pass

FOLDER, PROJECT, VICTIM, PARENT = {targets}
try:
    HERE = tempfile.mkdtemp()
    os.chdir(HERE)
except FileNotFoundError:
    # A process that may write nothing.
    HERE = os.getcwd()

def attempt(source):
    try:
        exec(source, dict(globals()))
    except BaseException as error:
        return type(error).__name__ + ": " + str(error)[:60]
    return "IN"

for name, source in {attacks}.items():
    print(json.dumps([name, attempt(source)]), flush=True)
"""


def try_contained(
    attacks: list[Attack], targets: Targets, standby: Standby | None = None
) -> dict[str, str]:
    """Try attacks in a program of LearnBlock; return what came of each ("IN": it got in)."""
    worker = ProcessWorker(standby)
    source = _source(attacks, targets)
    setup = Setup(source, "attack.py", str(targets.project), (), (), None, Limits())
    try:
        worker.link.send(setup)
        return dict(json.loads(text) for text in _printed(worker))
    finally:
        worker.kill()


def try_shared(attacks: list[Attack], targets: Targets) -> dict[str, str]:
    """The same in a process that a program shares with its host.

    Only programs that can name nothing of this get there; this one is let in to try the fence.
    """
    program = Program("attack.py", _source(attacks, targets), "")
    job = Job(program, robots.find("sim-ebo"), Options(world="empty"))
    warm = process_for_all()
    try:
        [(_, result)] = Batch([job], kept=warm).results()
    finally:
        warm.end()
    assert (result.isolated, result.report.error) == (False, None)
    return dict(json.loads(text) for text in result.report.output.splitlines())


def process_for_all() -> WarmProcess:
    """A process that lets every program share that of its host."""
    with patch.object(batch.subprocess, "Popen", _start_for_all):
        return WarmProcess()


def children(process: WarmProcess) -> list[int]:
    """The numbers of the processes that it has forked or started, and that have not ended."""
    number = process._process.pid
    with suppress(OSError):
        return [*map(int, Path(f"/proc/{number}/task/{number}/children").read_text().split())]
    return []


def _start_for_all(command: list[str], **settings: Any) -> "subprocess.Popen[bytes]":
    code = "from learnblock.running import warm; warm.is_plain = bool; warm.main()"
    return _POPEN([*command[:2], "-c", code, command[-1]], **settings)


def prepare(folder: Path) -> tuple[Path, Path]:
    """Make the files that attacks aim at; return another person's folder and the program's own."""
    others, project = folder / "others", folder / "project"
    for name in ("secret.txt", "emptied.txt", "removed.txt", "moved.txt", ".bashrc"):
        (others / name).parent.mkdir(parents=True, exist_ok=True)
        (others / name).write_text("secret")
    (others / "empty").mkdir(exist_ok=True)
    project.mkdir(exist_ok=True)
    (project / "data.txt").write_text("1 2 3")
    (folder / ".hidden").write_text("secret")
    for own in (project, folder):
        with suppress(FileExistsError):
            (own / "link").symlink_to(others / "secret.txt")
    home = Path(os.environ["LEARNBLOCK_HOME"])
    for name in ("settings.toml", "projects/ana.learnblock", "robots/mine.py", "skills/mine.py"):
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text("")
    return others, project


def _printed(worker: ProcessWorker) -> list[str]:
    text = ""
    assert worker.link.receive(30) == Contained()
    while not isinstance(message := worker.link.receive(30), Ended):
        assert isinstance(message, Printed), message
        text += message.text
    assert message.fault is None, message
    return text.splitlines()


def _source(attacks: list[Attack], targets: Targets) -> str:
    aims = (str(targets.folder), str(targets.project), targets.victim, os.getpid())
    pieces = {attack.name: attack.source for attack in attacks}
    return _PRELUDE.replace("{targets}", repr(aims)).replace("{attacks}", repr(pieces))


def _group(by: str, **sources: str) -> list[Attack]:
    return [Attack(name.replace("_", " "), by, source) for name, source in sources.items()]


#: How each of them answers.
ANSWERS = {
    "Landlock": "PermissionError: [Errno 13]",
    "seccomp": ("PermissionError: [Errno 1]", "OSError: [Errno 38]", "ValueError: not allowed"),
    "audit hook": "ForbiddenError",
    "resource limit": ("MemoryError", "OSError", "Refused"),
    "clean start": "Refused",
}
LANDLOCK, SECCOMP, LIMIT, START, HOOK = (
    "Landlock", "seccomp", "resource limit", "clean start", "audit hook",
)  # fmt: skip

READING = _group(
    LANDLOCK,
    read_the_list_of_users="open('/etc/passwd').read()",
    read_a_file_elsewhere="open(FOLDER + '/secret.txt').read()",
    read_it_with_system_calls="os.read(call(2, (FOLDER + '/secret.txt').encode(), 0), 9)",
    read_it_by_a_roundabout_path="open(PROJECT + '/../others/secret.txt').read()",
    read_it_through_the_root_of_proc="open('/proc/self/root' + FOLDER + '/secret.txt').read()",
    follow_a_link_of_its_project="open(PROJECT + '/link').read()",
    list_a_folder_elsewhere="os.listdir(FOLDER)",
    list_the_root_folder="os.listdir('/')",
    read_the_settings_with_passwords=(
        "open(os.environ['LEARNBLOCK_HOME'] + '/settings.toml').read()"
    ),
    read_another_pupils_project=(
        "open(os.environ['LEARNBLOCK_HOME'] + '/projects/ana.learnblock').read()"
    ),
    list_the_temporary_folders_of_others="os.listdir(os.path.dirname(tempfile.gettempdir()))",
    read_the_servers_variables="open(f'/proc/{PARENT}/environ', 'rb').read()",
    read_the_servers_memory="open(f'/proc/{PARENT}/mem', 'rb')",
    open_a_file_of_the_server="os.open(f'/proc/{PARENT}/fd/0', os.O_RDONLY)",
    list_all_processes="os.listdir('/proc')",
    read_the_command_of_a_process="open(f'/proc/{VICTIM}/cmdline').read()",
    read_its_own_memory_map="open('/proc/self/maps').read()",
    read_the_kernels_messages="open('/dev/kmsg')",
    open_the_terminal="os.open('/dev/ptmx', os.O_RDWR)",
    list_terminals="os.listdir('/dev/pts')",
    list_devices="os.listdir('/dev')",
)
#: For a program that is directly in a folder with folders of others.
IN_SHARED_FOLDER = _group(
    LANDLOCK,
    list_the_names_in_a_folder_below="os.listdir(FOLDER)",
    look_for_names_everywhere_below=(
        "if not [name for _, folders, names in os.walk(PROJECT) for name in folders + names]:\n"
        "    raise PermissionError(13, 'nothing found')"
    ),
    list_the_names_beside_it="os.listdir(PROJECT)",
    list_them_by_its_descriptor="os.listdir(os.open(PROJECT, os.O_RDONLY | os.O_DIRECTORY))",
    read_a_file_in_a_folder_below="open(FOLDER + '/secret.txt').read()",
    read_a_hidden_file_beside_it="open(PROJECT + '/.hidden').read()",
    follow_a_link_beside_it="open(PROJECT + '/link').read()",
)
WRITING = _group(
    LANDLOCK,
    write_a_file_elsewhere="open(FOLDER + '/new.txt', 'w')",
    add_to_the_shells_start="open(FOLDER + '/.bashrc', 'a').write('x')",
    put_a_robot_into_the_users_folder="open(os.environ['LEARNBLOCK_HOME'] + '/robots/r.py', 'w')",
    change_a_skill_of_the_user="open(os.environ['LEARNBLOCK_HOME'] + '/skills/mine.py', 'a')",
    write_into_its_own_project="open(PROJECT + '/helper.py', 'w')",
    change_python="open(os.__file__, 'a')",
    change_learnblock="import learnblock; open(learnblock.__file__, 'a')",
    put_compiled_code_beside_a_module="import json; open(json.__cached__, 'r+b')",
    delete_a_file_elsewhere="os.unlink(FOLDER + '/removed.txt')",
    move_a_file_here="os.rename(FOLDER + '/moved.txt', 'mine.txt')",
    make_a_folder_elsewhere="os.mkdir(FOLDER + '/new')",
    delete_a_folder_elsewhere="os.rmdir(FOLDER + '/empty')",
    write_to_shared_memory="open('/dev/shm/learnblock-attack', 'w')",
) + _group(
    SECCOMP,
    empty_a_file_elsewhere="os.truncate(FOLDER + '/emptied.txt', 0)",
    read_through_a_symbolic_link=(
        "os.symlink(FOLDER + '/secret.txt', 'link'); open('link').read()"
    ),
    make_a_symbolic_link="os.symlink('/etc', 'etc')",
    make_a_named_pipe="os.mkfifo('pipe')",
    make_a_device="os.mknod('null', stat.S_IFCHR | 0o600, os.makedev(1, 3))",
    make_a_hard_link="os.link(PROJECT + '/data.txt', 'hard')",
    empty_a_file_that_it_may_read="os.open(PROJECT + '/data.txt', os.O_RDONLY | os.O_TRUNC)",
    change_the_mode_of_a_file="os.chmod(FOLDER + '/secret.txt', 0o777)",
    change_the_owner_of_a_file="os.chown(FOLDER + '/secret.txt', 0, 0)",
    change_the_dates_of_a_file="os.utime(FOLDER + '/secret.txt', (0, 0))",
    change_the_attributes_of_a_file="os.setxattr(FOLDER + '/secret.txt', 'user.x', b'x')",
    watch_a_folder_elsewhere="call(254, call(253), FOLDER.encode(), 0x100)",
    watch_the_whole_disk="call(300, 0, 0)",
    get_a_handle_of_a_file=(
        "call(303, -100, (FOLDER + '/secret.txt').encode(), struct.pack('Ii128x', 128, 0),"
        " ctypes.byref(ctypes.c_int()), 0)"
    ),
    change_the_root_folder="os.chroot(HERE)",
    mount_a_folder="call(165, b'none', HERE.encode(), b'tmpfs', 0, None)",
    lock_a_file_that_it_may_read="import fcntl; fcntl.flock(open(PROJECT + '/data.txt'), 2)",
)
PROCESSES = _group(
    HOOK,
    fork="forked(os.fork())",
    start_a_command="os.system('true')",
    start_a_program="import subprocess; subprocess.run(['true'], check=True)",
    replace_itself="os.execv('/bin/true', ['true'])",
    spawn_a_program="forked(os.posix_spawn('/bin/true', ['true'], {}))",
) + _group(
    SECCOMP,
    fork_with_the_hook_removed="unhooked(); forked(os.fork())",
    fork_in_c="forked(c('fork'))",
    fork_by_system_call="forked(call(57))",
    clone_by_system_call="forked(call(56, 17, 0, 0, 0, 0))",
    clone_in_the_new_way="forked(call(435, struct.pack('8Q', 0, 0, 0, 0, 17, 0, 0, 0), 64))",
    clone_into_a_namespace="forked(call(56, 0x10000000 | 17, 0, 0, 0, 0))",
    fork_with_the_hidden_module=(
        "import _posixsubprocess as p; n = os.pipe()\n"
        "a = [[b'true'], [b'/bin/true'], True, (), None, None, -1, -1, -1, -1, -1, -1, *n,"
        " True, False, -1]\n"
        "a += [None, None, None, -1, None] + [True] * (sys.version_info < (3, 14))\n"
        "forked(p.fork_exec(*a))"
    ),
    spawn_as_multiprocessing_does=(
        "from multiprocessing.util import spawnv_passfds as s\n"
        "forked(s(b'/bin/true', [b'true'], ()))"
    ),
    replace_itself_in_c="c('execve', b'/bin/true', (ctypes.c_char_p * 2)(b'true'), None)",
    run_a_file_by_descriptor=(
        "call(322, os.open('/bin/true', os.O_RDONLY), b'',"
        " (ctypes.c_char_p * 2)(b'true'), None, 0x1000)"
    ),
    make_a_file_in_memory="os.memfd_create('x')",
    begin_a_session="c('setsid')",
    leave_its_process_group="c('setpgid', 0, VICTIM)",
    enter_a_new_namespace="call(272, 0x10000000)",
    enter_anothers_namespace="call(308, os.open('/proc/self/ns/net', os.O_RDONLY), 0)",
)
SIGNALS = _group(
    HOOK,
    signal_the_server="os.kill(PARENT, 0)",
) + _group(
    SECCOMP,
    signal_the_server_with_the_hook_removed="unhooked(); os.kill(PARENT, 0)",
    signal_the_server_in_c="c('kill', PARENT, 0)",
    signal_everybody="c('kill', -VICTIM, 0)",
    signal_a_thread_of_the_server="call(234, PARENT, PARENT, 0)",
    signal_any_thread="call(200, VICTIM, 0)",
    queue_a_signal="call(129, VICTIM, 0, struct.pack('iii116x', 0, 0, -1))",
    signal_the_server_by_descriptor="signal.pidfd_send_signal(os.pidfd_open(PARENT), 0)",
    take_a_descriptor_of_the_server="call(438, call(434, PARENT, 0), 0, 0)",
    have_the_kernel_signal_another=(
        "import fcntl; a, b = socket.socketpair(); fcntl.fcntl(a, fcntl.F_SETOWN, VICTIM)"
    ),
    have_it_signal_by_another_way=(
        "import fcntl; a, b = socket.socketpair()\nfcntl.ioctl(a, 0x8901, struct.pack('i', VICTIM))"
    ),
    trace_another_process="call(101, 16, VICTIM, 0, 0); call(101, 17, VICTIM, 0, 0)",
    trace_it_without_stopping_it="call(101, 0x4206, VICTIM, 0, 0)",
    read_the_memory_of_another=(
        "b = ctypes.create_string_buffer(8)\n"
        "call(310, VICTIM, struct.pack('PN', ctypes.addressof(b), 0), 1, b'', 0, 0)"
    ),
    write_the_memory_of_another="call(311, VICTIM, None, 0, None, 0, 0)",
    change_the_limits_of_another=(
        "resource.prlimit(VICTIM, resource.RLIMIT_CORE, (0, resource.RLIM_INFINITY))"
    ),
    read_the_limits_of_another="resource.prlimit(VICTIM, resource.RLIMIT_CORE)",
    change_the_priority_of_another="os.setpriority(os.PRIO_PROCESS, VICTIM, 1)",
    move_another_to_a_processor="os.sched_setaffinity(VICTIM, os.sched_getaffinity(VICTIM))",
    change_its_turn_at_the_disk="call(251, 1, VICTIM, 4 << 13)",
    compare_two_processes="call(312, os.getpid(), VICTIM, 0, 0, 0)",
    outlive_the_server="c('prctl', 1, 0, 0, 0, 0)",
)
NETWORK = _group(
    SECCOMP,
    open_a_tcp_socket="socket.socket()",
    open_a_udp_socket="socket.socket(type=socket.SOCK_DGRAM)",
    open_it_by_system_call="call(41, 2, 1, 0)",
    open_a_socket_of_ipv6="socket.socket(socket.AF_INET6)",
    open_a_raw_socket="socket.socket(socket.AF_INET, socket.SOCK_RAW, 1)",
    open_a_socket_on_the_wire="socket.socket(socket.AF_PACKET, socket.SOCK_RAW)",
    open_a_socket_to_the_kernel="socket.socket(socket.AF_NETLINK, socket.SOCK_RAW)",
    open_a_unix_socket="socket.socket(socket.AF_UNIX)",
    open_an_abstract_socket="socket.socket(socket.AF_UNIX).bind('\\0learnblock-attack')",
    send_from_a_pair_to_another=(
        "a, b = socket.socketpair(type=socket.SOCK_DGRAM)\n"
        "e, f = socket.socketpair(type=socket.SOCK_DGRAM); e.send(b'x')"
    ),
    pass_a_descriptor_on=("a, b = socket.socketpair(); socket.send_fds(a, [b'x'], [b.fileno()])"),
    share_memory_with_others="call(29, 0x1eab, 4096, 0o1666)",
    send_messages_to_others="call(68, 0x1eab, 0o1666)",
    make_a_queue_of_messages="call(240, b'learnblock-attack', 0o100 | 1, 0o600, None)",
) + _group(
    HOOK,
    look_up_a_name="socket.getaddrinfo('localhost', 80)",
)
KERNEL = _group(
    SECCOMP,
    make_a_ring_of_calls="call(425, 2, ctypes.create_string_buffer(120))",
    load_a_program_into_the_kernel=(
        "call(321, 0, struct.pack('IIII', 2, 4, 8, 1) + bytes(112), 128)"
    ),
    count_the_events_of_others=(
        "call(298, struct.pack('IIQ', 1, 128, 0) + bytes(112), -1, 0, -1, 0)"
    ),
    handle_the_faults_of_memory="call(323, 1)",
    add_a_key="call(248, b'user', b'learnblock-attack', b'x', 1, -1)",
    read_the_keys="call(250, 0, -3, 1)",
    read_the_log="call(103, 10, None, 0)",
    change_its_personality="call(135, 0x0040000)",
    become_another_user="os.setuid(os.getuid())",
    change_its_groups="os.setgroups(os.getgroups())",
    change_its_rights="call(125, struct.pack('II', 0x20080522, 0), None)",
    fake_typing="import fcntl; fcntl.ioctl(os.pipe()[0], 0x5412, b'x')",
    set_the_clock="import time; time.clock_settime(0, time.clock_gettime(0))",
    change_the_hosts_name="n = os.uname().nodename; c('sethostname', n.encode(), len(n))",
    use_ports_of_the_computer="call(173, 0x80, 1, 1)",
    change_its_segments="call(154, 0, ctypes.create_string_buffer(16), 16)",
    keep_its_memory_from_the_disk="call(151, 1)",
    run_above_all_others="os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))",
)
LIMITS = _group(
    LIMIT,
    take_ten_gigabytes="bytearray(10 ** 10)",
    map_ten_gigabytes="mmap.mmap(-1, 10 ** 10)",
    write_a_large_file="open('large', 'wb').truncate(10 ** 8)",
    open_many_files="files = [open(os.devnull) for _ in range(100)]",
    leave_a_core_dump=(
        "if resource.getrlimit(resource.RLIMIT_CORE)[1] == 0: raise Refused('no dumps')"
    ),
) + _group(
    SECCOMP,
    raise_its_limits="resource.setrlimit(resource.RLIMIT_NOFILE, (4096, 4096))",
    raise_them_by_system_call="call(302, 0, 7, struct.pack('QQ', 4096, 4096), None)",
    have_its_dumps_back="resource.setrlimit(resource.RLIMIT_CORE, (1, 1))",
)
DESCRIPTORS = _group(
    START,
    find_the_servers_token=(
        "if 'LEARNBLOCK_TOKEN' not in os.environ: raise Refused('not in the variables')"
    ),
    find_the_users_folder=(
        "import pwd; home = pwd.getpwuid(os.getuid()).pw_dir\n"
        "if os.environ['HOME'] != home: raise Refused('another folder')"
    ),
    inherit_a_file_of_the_server=(
        "found = [n for n in range(3, 64) if not libc.fcntl(n, 1) == -1"
        " and not stat.S_ISSOCK(os.fstat(n).st_mode)]\n"
        "if not found: raise Refused('none')"
    ),
    write_to_the_servers_output=(
        "if os.fstat(2).st_rdev == os.makedev(1, 3): raise Refused('/dev/null')"
    ),
)

GROUPS = {
    "reading": READING,
    "writing": WRITING,
    "processes": PROCESSES,
    "signals": SIGNALS,
    "network": NETWORK,
    "kernel": KERNEL,
    "limits": LIMITS,
    "descriptors": DESCRIPTORS,
}
#: Attacks that get in, with the reason; named in docs/containment.md.
NOT_CONTAINED = _group(
    "nothing: Landlock does not hide names",
    ask_for_the_size_of_a_file="os.stat(FOLDER + '/secret.txt')",
    ask_whether_a_process_exists="os.stat(f'/proc/{VICTIM}')",
)
#: What a program could do besides, if it got out of the language in a process that it shares with
#: its host, which reads the settings and sends the result; named in docs/containment.md.
NOT_CONTAINED_IF_SHARED = {"read the settings with passwords", "inherit a file of the server"}


def _beside(own: str) -> list[Attack]:
    """What a program could find of others.

    Args:
        own: how its process may use the descriptors that it has.
    """
    return _group(
        START,
        find_the_results_of_others=(
            "import fcntl, os\n"
            "found = [n for n in range(3, 64) if libc.fcntl(n, 1) != -1]\n"
            "uses = sorted(libc.fcntl(n, fcntl.F_GETFL) & os.O_ACCMODE for n in found)\n"
            f"if uses == [{own}]: raise Refused('only its own')"
        ),
    )


#: A program in a process of its own has a connection with its host.
BESIDE = _beside("os.O_RDWR")
#: One that shares that of its host has a pipe from which its further runs come, and one for all
#: results.
BESIDE_IF_SHARED = _beside("os.O_RDONLY, os.O_WRONLY")
