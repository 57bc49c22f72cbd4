"""Programs through the real Blockly: what it is shown is what it gives back."""

import mimetypes
import os
import shutil
import subprocess
from pathlib import Path

import msgspec
import pytest

from learnblock.blocks.palette import palette
from learnblock.language import Workspace, from_workspace, parse, to_workspace
from learnblock.language.workspace import Block
from workspaces import CONFIGURATIONS, BlockTrees, as_json, blocks

ROOT = Path(__file__).parents[2]
HARNESS = Path(__file__).parent / "roundtrip"
PROGRAMS = sorted([*ROOT.glob("examples/*.bt"), *ROOT.glob("tests/cases/*/program.bt")])
RANDOM = 2000
BATCH = 100
#: Answers no request itself: the test does.
PLACE = "http://roundtrip.test/"


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The page's editor of blocks, built into a folder."""
    npx = shutil.which("npx")
    if npx is None and not os.environ.get("CI"):
        pytest.skip("no Node.js on this machine, which builds the page")
    assert npx, "CI has no Node.js"
    folder = tmp_path_factory.mktemp("roundtrip")
    subprocess.run(
        [npx, "vite", "build", HARNESS, "--config", "vite.config.ts", "--outDir", folder],
        cwd=ROOT / "frontend",
        check=True,
    )
    return folder


@pytest.fixture(scope="module")
def blockly(browser, built):
    """A page with Blockly in it; answers what became of workspaces that it was shown in turn."""
    context = browser.new_context()
    page = context.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.route(f"{PLACE}**", lambda route: answer(route, built))
    page.goto(PLACE)
    page.wait_for_function("'roundTrip' in globalThis")

    def through(workspaces):
        shown = f"[{','.join(map(as_json, workspaces))}]"
        back = page.evaluate("all => JSON.stringify(JSON.parse(all).map(roundTrip))", shown)
        return msgspec.json.decode(back, type=list[Workspace])

    yield through
    context.close()
    assert errors == []


def answer(route, folder):
    path = route.request.url.removeprefix(PLACE) or "index.html"
    if path == "palette/en.json":
        route.fulfill(json=palette(CONFIGURATIONS, "en"))
    else:
        kind = mimetypes.guess_type(path)[0]
        route.fulfill(body=(folder / path).read_bytes(), content_type=kind)


def blocks_of(program):
    return to_workspace(program, CONFIGURATIONS).workspace


def read(workspace):
    return from_workspace(workspace, CONFIGURATIONS).program


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_an_example_is_the_same_program_after_blockly_has_had_it(blockly, path):
    program = parse(path.read_text("utf-8"))
    (back,) = blockly([blocks_of(program)])
    assert read(back) == program


def test_random_programs_are_the_same_after_blockly_has_had_them(blockly):
    changed = {}
    for first in range(0, RANDOM, BATCH):
        seeds = range(first, first + BATCH)
        programs = [BlockTrees(seed).program() for seed in seeds]
        shown = list(map(blocks_of, programs))
        for seed, program, before, after in zip(
            seeds, programs, shown, blockly(shown), strict=True
        ):
            if read(after) != program:
                changed[seed] = differences(before, after)
    assert changed == {}


def test_a_loose_call_of_a_function_that_is_gone_stays(blockly):
    call = Block("procedures_callnoreturn", "call", x=1, y=2)
    call.extraState = {"name": "step", "params": ["angle"]}
    (back,) = blockly([Workspace([[call]])])
    assert [block.id for block in blocks(back)] == ["call"]


def differences(before, after):
    """The blocks that Blockly has changed: each as it was, and as it is now."""
    was, now = by_id(before), by_id(after)
    ids = dict.fromkeys([*was, *now])
    return {one: (was.get(one), now.get(one)) for one in ids if was.get(one) != now.get(one)}


def by_id(workspace):
    """Every block by its id, with the ids of what is plugged in."""
    return {block.id: own(block) for block in blocks(workspace)}


def own(block):
    plugged = {
        name: [one.id for one in (plug.block, plug.shadow, *plug.stack) if one]
        for name, plug in block.inputs.items()
    }
    return (block.type, block.fields, block.extraState, block.comment, block.data, plugged)
