"""What a pupil's program can do to the computer that it runs on: the table of attacks."""

import re
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from attacks import (
    ANSWERS,
    BESIDE,
    BESIDE_IF_SHARED,
    COMPLETE,
    GROUPS,
    IN_SHARED_FOLDER,
    NOT_CONTAINED,
    NOT_CONTAINED_IF_SHARED,
    Targets,
    prepare,
    try_contained,
    try_shared,
)
from learnblock.i18n import Phrase
from learnblock.runtime.containment import seccomp, syscalls
from learnblock.runtime.containment.survey import survey
from learnblock.runtime.ending import How
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import Limits

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.certain,
    pytest.mark.skipif(sys.platform != "linux", reason="Landlock and seccomp are Linux's"),
]
complete = pytest.mark.skipif(not COMPLETE, reason="needs Linux 6.12 on x86-64")


@pytest.fixture
def targets(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("LEARNBLOCK_TOKEN", "secret")
    others, project = prepare(tmp_path)
    victim = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    yield Targets(others, project, victim.pid)
    victim.communicate(b"\n")


def got_in(attacks, results):
    """The attacks that were not refused as they should be."""
    assert [attack.name for attack in attacks] == list(results)
    return [
        (attack, results[attack.name])
        for attack in attacks
        if not results[attack.name].startswith(ANSWERS[attack.by])
    ]


@complete
@pytest.mark.parametrize("group", GROUPS)
def test_every_attack_of_the_group_is_refused(targets, group):
    attacks = GROUPS[group]
    assert got_in(attacks, try_contained(attacks, targets)) == []


@complete
def test_the_process_of_a_fork_server_refuses_every_attack_and_finds_nothing_of_others(targets):
    server = ForkServer()
    server.begin()
    try:
        # Another program's process is there, too.
        with server.standby():
            for attacks in (BESIDE, *GROUPS.values()):
                results = try_contained(attacks, targets, server.standby())
                assert got_in(attacks, results) == []
    finally:
        server.end()


@complete
def test_a_program_beside_folders_of_others_learns_no_name_there(targets):
    results = try_contained(IN_SHARED_FOLDER, targets.in_shared_folder)
    assert [attack.name for attack in IN_SHARED_FOLDER] == list(results)
    assert {answer[: len(ANSWERS["Landlock"])] for answer in results.values()} == {
        ANSWERS["Landlock"]
    }


@complete
def test_what_is_not_contained_is_known(targets):
    assert set(try_contained(NOT_CONTAINED, targets).values()) == {"IN"}


@complete
def test_a_process_shared_with_its_host_refuses_every_attack_but_the_known_ones(targets):
    attacks = [*BESIDE_IF_SHARED, *(attack for group in GROUPS.values() for attack in group)]
    results = try_shared(attacks, targets)
    assert [attack.name for attack in attacks] == list(results)
    got_in = {name for name, answer in results.items() if answer == "IN"}
    assert got_in == NOT_CONTAINED_IF_SHARED


def test_there_are_at_least_seventy_attacks():
    assert sum(len(group) for group in GROUPS.values()) >= 70


FILLING = {
    "many large files": (
        "for i in range(9):\n    open(str(i), 'wb').write(bytes(10**7))\n",
        "run-too-much-disk",
    ),
    "many files that are deleted while open": (
        "import os\nfiles = []\nfor i in range(9):\n    files.append(open(str(i), 'wb'))\n"
        "    files[-1].write(bytes(10**7))\n    files[-1].flush()\n    os.unlink(str(i))\n",
        "run-too-much-disk",
    ),
    "many files that are deleted while mapped": (
        "import mmap, os\nmaps = []\nfor i in range(9):\n    file = open(str(i), 'w+b')\n"
        "    file.write(bytes(10**7))\n    file.flush()\n"
        "    maps.append(mmap.mmap(file.fileno(), 4096))\n    file.close()\n"
        "    os.unlink(str(i))\n",
        "run-too-much-disk",
    ),
    "many small files": (
        "for i in range(2000):\n    open(str(i), 'w').close()\n",
        "run-too-many-files",
    ),
    "many threads": (
        "import threading\nthreading.stack_size(65536)\nfor i in range(150):\n"
        "    threading.Thread(target=threading.Event().wait).start()\n",
        "run-too-many-threads",
    ),
}


@pytest.mark.parametrize("name", FILLING)
def test_a_program_that_occupies_too_much_is_ended(run, name):
    source, code = FILLING[name]
    result = run(source + "import time\nwhile True: pass", limits=Limits(silence=30))
    assert (How.KILLED, code) == (result.how, result.ending.phrase.code)
    result.wait_until_gone()


def test_the_temporary_folder_is_removed_however_deep_it_is(run):
    deepen = "for i in range(1500):\n    os.mkdir('d')\n    os.chdir('d')\n"
    result = run("import os\nprint(os.getcwd())\n" + deepen)
    assert not Path(result.output.strip()).exists()


def test_a_program_without_a_project_works_in_its_temporary_folder(run):
    source = "open('notes.txt', 'w').write('hello')\nprint(open('notes.txt').read())"
    assert run(source).output == "hello\n"


def test_a_refused_file_is_named_with_what_is_allowed(run):
    result = run("open('/etc/passwd')")
    assert result.ending.phrase == Phrase("run-no-access", file="/etc/passwd")


@pytest.mark.parametrize("shared", [False, True], ids=["a folder of its own", "a home folder"])
def test_a_program_may_read_its_project_and_import_from_it(run, tmp_path, monkeypatch, shared):
    project = tmp_path / "project"
    # A folder with the user's own folder in it has things of others.
    monkeypatch.setenv("LEARNBLOCK_HOME", str((project if shared else tmp_path) / "home"))
    monkeypatch.chdir(tmp_path)
    project.mkdir()
    (project / "helper.py").write_text("def greet(): print('hello')\n")
    (project / "map.txt").write_text("a map")
    source = (
        f"import helper\nhelper.greet()\nprint(open({str(project / 'map.txt')!r}).read())\n"
        "print(open('project/map.txt').read(), helper.__file__)"
    )
    expected = f"hello\na map\na map {project / 'helper.py'}\n"
    assert run(source, folder=str(project)).output == expected


def test_a_program_may_use_numpy_threads_and_an_event_loop(run):
    result = run(
        "import asyncio, threading, hashlib, ssl, tempfile\nimport numpy\n"
        "def add(): print(numpy.ones((50, 50)).dot(numpy.ones(50))[0])\n"
        "thread = threading.Thread(target=add)\n"
        "thread.start()\nthread.join()\n"
        "async def main(): await asyncio.sleep(0)\nasyncio.run(main())\n"
        "with tempfile.TemporaryDirectory() as folder: print(hashlib.md5(b'').hexdigest()[:4])\n"
    )
    assert (How.FINISHED, "50.0\nd41d\n") == (result.how, result.output)


def test_a_system_call_of_another_processor_ends_the_program(run):
    if not COMPLETE:
        pytest.skip("needs seccomp on x86-64")
    # mov eax, 20 (getpid of 32 bits); int 0x80; ret
    code = r"b'\xb8\x14\x00\x00\x00\xcd\x80\xc3'"
    result = run(
        f"import ctypes, mmap\nm = mmap.mmap(-1, 4096, prot=7)\nm.write({code})\n"
        "at = ctypes.addressof(ctypes.c_char.from_buffer(m))\n"
        "ctypes.CFUNCTYPE(ctypes.c_int)(at)()\n"
    )
    assert result.ending.phrase == Phrase("run-killed", signal="SIGSYS")


CONNECTING = """
import socket
found = socket.getaddrinfo("127.0.0.1", {port})
with socket.create_connection(("127.0.0.1", {port})) as connection:
    print(connection.recv(5).decode())
"""


def test_a_program_that_may_use_the_network_reaches_it(run):
    with socket.create_server(("127.0.0.1", 0)) as server:
        answering = threading.Thread(target=answer, args=(server,))
        answering.start()
        result = run(CONNECTING.format(port=server.getsockname()[1]), network=True)
        answering.join()
    assert result.output == "hello\n"


def answer(server):
    server.settimeout(20)
    connection, _ = server.accept()
    with connection:
        connection.sendall(b"hello")


def test_a_program_that_may_not_use_the_network_is_told_how_it_could(run):
    result = run(CONNECTING.format(port=1))
    assert result.ending.phrase == Phrase("run-no-network", event="socket.getaddrinfo")


HEADERS = {
    "x86_64": Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h"),
    "aarch64": Path("/usr/include/asm-generic/unistd.h"),
}


@pytest.mark.parametrize("processor", HEADERS)
def test_the_numbers_of_calls_are_those_of_the_kernels_headers(processor):
    header = HEADERS[processor]
    if not header.exists():
        pytest.skip("the kernel's headers are not installed")
    plain = re.findall(r"#define __NR_(\w+)\s+(\d+)\s", header.read_text())
    known = {name: int(number) for name, number in plain}
    ours = syscalls.numbers(processor, network=True) | syscalls.refused(
        processor, network=False, programs=False, files=False
    )
    assert {
        name: number for name, number in ours.items() if known.get(name, number) != number
    } == {}
    assert len(ours.keys() & known.keys()) > 100


def test_a_32_bit_python_on_a_64_bit_kernel_gets_no_filter(monkeypatch):
    monkeypatch.setattr(sys, "maxsize", 2**31 - 1)
    assert not seccomp.is_supported.__wrapped__()


def test_the_survey_finds_by_trying_what_contains_programs_here(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    if not COMPLETE:
        pytest.skip("needs Landlock and seccomp")
    assert [str(one.name) for one in survey() if not one.contained] == []


def test_a_kernel_without_landlock_is_reported_with_the_reason(monkeypatch):
    for attempts in ("_refused", "_refused_to_driver"):
        monkeypatch.setattr(f"learnblock.runtime.containment.survey.{attempts}", frozenset)
    found = {one.name.code: one for one in survey()}
    assert not any(one.contained for one in found.values())
    for code in ("doctor-read", "doctor-driver-write"):
        assert found[code].reason.code == "doctor-no-landlock"
    for code in ("doctor-network", "doctor-driver-network", "doctor-driver-processes"):
        assert found[code].reason.code == "doctor-no-seccomp"


def test_on_another_system_nothing_is_said_to_contain_a_driver(monkeypatch):
    monkeypatch.setattr("learnblock.runtime.containment.survey._refused", frozenset)
    monkeypatch.setattr(sys, "platform", "darwin")
    reasons = {one.name.code: one.reason.code for one in survey() if not one.contained}
    assert reasons["doctor-driver-write"] == "doctor-other-system-driver"
    assert reasons["doctor-network"] == "doctor-other-system"
