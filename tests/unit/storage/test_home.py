import os
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import ModuleType

from learnblock.storage.home import home, import_file


def test_home_is_set_by_the_environment(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "/somewhere")
    assert home() == Path("/somewhere")


def test_home_is_otherwise_a_folder_named_learnblock_for_the_systems_configuration(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "")
    assert home().name == "learnblock"
    assert home().is_absolute()


def test_a_file_in_the_users_folder_is_run_once_and_again_only_after_a_change(own_home):
    path = own_home / "robots" / "mine.py"
    path.parent.mkdir()
    path.write_text("speed = 1\n")
    first = import_file(path)
    assert import_file(path) is first
    path.write_text("speed = 20\n")
    os.utime(path, ns=(0, 0))
    assert import_file(path).speed == 20


def test_two_threads_that_import_a_file_at_once_both_get_all_of_it(own_home, monkeypatch):
    gate = ModuleType("gate_of_the_test")
    gate.entered, gate.release = threading.Event(), threading.Event()
    monkeypatch.setitem(sys.modules, gate.__name__, gate)
    path = own_home / "robots" / "slow.py"
    path.parent.mkdir()
    path.write_text(
        f"import {gate.__name__} as gate\ngate.entered.set()\ngate.release.wait(20)\nspeed = 20\n"
    )
    with ThreadPoolExecutor(2) as threads:
        first = threads.submit(import_file, path)
        assert gate.entered.wait(20)
        second = threads.submit(import_file, path)
        gate.release.set()
        assert second.result(20).speed == first.result(20).speed == 20
