"""A run in one file, opened from a disk by a browser without a network."""

import re
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from learnblock.notebook.cell_pages import framed
from places import ROOT

LARGEST = 2_000_000
SQUARE = ROOT / "examples" / "first" / "square.bt"
AVOID = ROOT / "examples" / "avoid.bt"


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A page that shows a run."""
    path = tmp_path_factory.mktemp("home") / "square.html"
    command = ["run", SQUARE, "--robot", "sim-ebo", "--world", "obstacles", "--page", path]
    subprocess.run([sys.executable, "-m", "learnblock", *map(str, command)], check=True, timeout=60)
    return path


@pytest.fixture
def page(browser, file):
    context = browser.new_context(viewport={"width": 1366, "height": 768}, offline=True)
    page = context.new_page()
    page.errors, page.requests = [], []
    page.on("pageerror", lambda error: page.errors.append(str(error)))
    page.on("request", lambda request: page.requests.append(request.url.partition(":")[0]))
    page.goto(file.as_uri())
    yield page
    assert page.errors == []
    assert set(page.requests) <= {"file", "data", "blob"}
    context.close()


def test_a_run_is_looked_back_at_without_a_network(page, file):
    assert file.stat().st_size < LARGEST
    expect(page.locator(".take-home-world canvas")).to_be_visible()
    expect(page.locator(".lbRunning")).to_contain_text("drive")
    page.get_by_role("slider").press("End")
    expect(page.locator(".timeline-time")).to_have_text("15.04 s")
    page.get_by_role("button", name="Python").click()
    expect(page.locator(".take-home-text")).to_contain_text("robot.turn(90)")
    page.get_by_role("button", name="Why did the robot turn right on the spot at 2.14 s?").click()
    expect(page.locator(".why-answer")).to_contain_text("turn")
    page.get_by_role("button", name="See 2.14 s").click()
    expect(page.locator(".timeline-time")).to_have_text("2.14 s")
    expect(page.locator("[aria-current=step]")).to_contain_text("robot.turn(90)")


def test_each_robot_of_a_run_is_chosen_by_its_name(browser, tmp_path):
    path = tmp_path / "two.html"
    command = ["run", f"{SQUARE}@sim-ebo", f"{AVOID}@sim-ev3", "--world", "obstacles"]
    command += ["--for", "10", "--page", path, "--name", "Ada"]
    subprocess.run([sys.executable, "-m", "learnblock", *map(str, command)], check=True, timeout=60)
    context = browser.new_context(offline=True)
    page = context.new_page()
    page.goto(path.as_uri())
    expect(page).to_have_title("square, avoid · Ada – LearnBlock")
    expect(page.get_by_text("by Ada")).to_be_visible()
    blocks = page.get_by_role("group", name="Blocks", exact=True)
    expect(blocks).not_to_contain_text("obstacle")
    page.get_by_role("slider").press("End")
    page.get_by_role("button", name="avoid", exact=True).click()
    expect(blocks).to_contain_text("obstacle")
    expect(page.locator(".timeline-time")).to_have_text("10.00 s")
    expect(page.locator("header")).to_contain_text("EV3")
    context.close()


@pytest.mark.parametrize("size", [(1366, 768), (820, 1180), (390, 844)], ids=str)
def test_axe_finds_nothing_on_any_size(page, axe, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})
    expect(page.locator(".take-home-world canvas")).to_be_visible()
    # The page allows no script from elsewhere, but a debugger's.
    page.evaluate(axe)
    found = page.evaluate("async () => (await axe.run()).violations.map(({ id }) => id)")
    assert found == []


def in_a_page(_):
    """The frame in the docs."""
    docs = (ROOT / "docs" / "page.md").read_text("utf-8")
    return re.search(r"^<iframe .*</iframe>$", docs, re.MULTILINE)[0]


def in_a_notebook(file):
    return framed(file.read_text("utf-8"), "A square")


@pytest.mark.parametrize("frame_of", [in_a_page, in_a_notebook])
def test_it_works_in_a_frame_that_may_only_run_scripts(page, file, frame_of):
    host = file.with_name("host.html")
    host.write_text(frame_of(file), "utf-8")
    page.goto(host.as_uri())
    frame = page.frame_locator("iframe")
    expect(frame.locator(".take-home-world canvas")).to_be_visible()
    frame.get_by_role("slider").press("End")
    expect(frame.locator(".timeline-time")).to_have_text("15.04 s")
