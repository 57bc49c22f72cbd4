"""Round trips through the real Blockly: it returns the program that it was given."""

import json
import mimetypes
import os
import shutil
import subprocess

import msgspec
import pytest

from gate import examples
from learnblock.blocks.palette import palette
from learnblock.language import Workspace, from_workspace, parse, to_workspace
from learnblock.language.workspace.blocks import Block
from places import ROOT
from workspaces import CONFIGURATIONS, BlockTrees, as_json, blocks

pytestmark = pytest.mark.certain

FRONTEND = ROOT / "frontend"
HARNESS = FRONTEND / "tests" / "round-trip"
PROGRAMS = sorted([*ROOT.glob("examples/*.bt"), *ROOT.glob("tests/cases/*/program.bt")])
RANDOM = 2000
BATCH = 100
#: How many programs of a batch are tried.
TRIED = examples(BATCH, gate=25)
#: How many programs of a batch have their pictures drawn: all of them take five minutes.
DRAWN = 2
#: A made-up address, whose requests the test answers.
PLACE = "http://roundtrip.test/"
ROUND_TRIPS = """async all => {
    const back = [];
    for (const one of JSON.parse(all)) back.push(await roundTrip(one));
    return JSON.stringify(back);
}"""

PICTURES = """async all => {
    const words = [];
    for (const one of all) words.push(await wordsOfPicture(one));
    return words;
}"""


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The folder of the page's block editor, built for this test."""
    vite = shutil.which("vite", path=FRONTEND / "node_modules" / ".bin")
    if (vite is None or shutil.which("node") is None) and not os.environ.get("CI"):
        pytest.skip("no Vite on this machine, which builds the page: npm ci in frontend")
    assert vite, "CI has no Vite"
    folder = tmp_path_factory.mktemp("roundtrip")
    config = HARNESS / "vite.config.ts"
    subprocess.run(
        [vite, "build", HARNESS, "--config", config, "--outDir", folder], cwd=FRONTEND, check=True
    )
    return folder


@pytest.fixture(scope="module")
def harness(browser, built):
    """The page's block editor alone."""
    context = browser.new_context()
    page = context.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.route(f"{PLACE}**", lambda route: answer(route, built))
    page.goto(PLACE)
    page.wait_for_function("'roundTrip' in globalThis")
    yield page
    context.close()
    assert errors == []


@pytest.fixture(scope="module")
def blockly(harness):
    """A function that loads workspaces into Blockly in turn and returns them as saved."""

    def through(workspaces):
        back = harness.evaluate(ROUND_TRIPS, as_array(workspaces))
        return msgspec.json.decode(back, type=list[Workspace])

    return through


def as_array(workspaces):
    return f"[{','.join(map(as_json, workspaces))}]"


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
def test_an_example_survives_a_round_trip_through_blockly(blockly, path):
    program = parse(path.read_text("utf-8"))
    (back,) = blockly([blocks_of(program)])
    assert read(back) == program


@pytest.mark.parametrize("first", range(0, RANDOM, BATCH))
def test_random_programs_survive_a_round_trip_through_blockly(blockly, first):
    seeds = range(first, first + TRIED)
    programs = [BlockTrees(seed).program() for seed in seeds]
    shown = list(map(blocks_of, programs))
    changed = {
        seed: differences(before, after)
        for seed, program, before, after in zip(seeds, programs, shown, blockly(shown), strict=True)
        if read(after) != program
    }
    assert changed == {}


@pytest.mark.parametrize("first", range(0, RANDOM, BATCH))
def test_pictures_of_random_programs_have_all_words_of_their_blocks(harness, first):
    seeds = range(first, first + DRAWN)
    programs = [BlockTrees(seed).program() for seed in seeds]
    pictures = harness.evaluate(PICTURES, json.loads(as_array(map(blocks_of, programs))))
    assert sum(count for count, _ in pictures) > 20 * DRAWN
    missing = {seed: words for seed, (_, words) in zip(seeds, pictures, strict=True) if words}
    assert missing == {}


def test_a_detached_call_of_a_deleted_function_is_kept(blockly):
    call = Block("procedures_callnoreturn", "call", x=1, y=2)
    call.extraState = {"name": "step", "params": ["angle"]}
    (back,) = blockly([Workspace([[call]])])
    assert [block.id for block in blocks(back)] == ["call"]


def differences(before, after):
    """Return the blocks that Blockly has changed: each before and after."""
    was, now = by_id(before), by_id(after)
    ids = dict.fromkeys([*was, *now])
    return {one: (was.get(one), now.get(one)) for one in ids if was.get(one) != now.get(one)}


def by_id(workspace):
    """Return every block by its id, with the ids of its inputs."""
    return {block.id: own(block) for block in blocks(workspace)}


def own(block):
    plugged = {
        name: [one.id for one in (plug.block, plug.shadow, *plug.stack) if one]
        for name, plug in block.inputs.items()
    }
    return (block.type, block.fields, block.extraState, block.comment, block.data, plugged)
