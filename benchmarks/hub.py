"""Measure LearnBlock under JupyterHub: from the login to the editor, and what a user costs.

    python benchmarks/hub.py [users]

It needs the hub's proxy (docs/jupyterhub.md), a built page, Playwright and a Chromium
(``CHROMIUM=/path/to/it``). Users log in one after the other, each in a browser with an empty cache.
"""

import os
import platform
import statistics
import sys
import tempfile
from pathlib import Path
from time import perf_counter

from _browser import SIZE, TIMEOUT, chromium
from playwright.sync_api import Browser, Page
from sessions import megabytes, processor_time

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

import hubs

#: What is on the start page, and a block of the opened example.
START = "[data-region=start] button"
BLOCK = "[data-region=blocks] .blocklyBlockCanvas .blocklyDraggable"


def log_in(page: Page, hub: hubs.Hub, name: str) -> tuple[float, float]:
    """Return the seconds from the login to the start page, and to an example in the editor."""
    page.goto(f"{hub.address}/hub/login")
    page.fill("[name=username]", name)
    began = perf_counter()
    page.click("[type=submit]")
    page.locator(START).first.wait_for()
    started = perf_counter() - began
    page.locator(START).first.click()
    page.locator(BLOCK).first.wait_for()
    return started, perf_counter() - began


def measure(browser: Browser, hub: hubs.Hub, name: str) -> list[float]:
    page = browser.new_page(viewport=SIZE, locale="en")
    page.set_default_timeout(TIMEOUT)
    times = log_in(page, hub, name)
    processes = hub.jupyter_server(name), hub.server(name)
    used = [*map(megabytes, processes), *map(processor_time, processes)]
    page.close()
    return [*times, *used]


def report(measured: list[list[float]]) -> None:
    start, editor, *used = map(statistics.median, zip(*measured, strict=True))
    jupyter, learnblock, jupyter_time, learnblock_time = used
    print(f"login       {start:.1f} s to the start page, {editor:.1f} s to an example's blocks")
    print(f"            first user {measured[0][1]:.1f} s, last {measured[-1][1]:.1f} s")
    print(f"memory      {jupyter + learnblock:.0f} MB a user: ", end="")
    print(f"Jupyter server {jupyter:.0f}, LearnBlock {learnblock:.0f}")
    print(f"processors  {jupyter_time + learnblock_time:.1f} s a user: ", end="")
    print(f"Jupyter server {jupyter_time:.1f}, LearnBlock {learnblock_time:.1f}")


def main() -> None:
    users = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {users} users")
    with (
        tempfile.TemporaryDirectory() as folder,
        hubs.running(Path(folder), hubs.proxy_command()) as hub,
        chromium() as browser,
    ):
        report([measure(browser, hub, f"user{number}") for number in range(users)])
        print(f"the hub     {megabytes(hub.process):.0f} MB without its proxy")


if __name__ == "__main__":
    main()
