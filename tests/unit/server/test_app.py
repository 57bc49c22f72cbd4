"""The server's responses to plain requests."""

import gzip
import json
from urllib.parse import quote

import pytest

from pages import TOKEN, serving

SCRIPT = "export const page = 1;\n" * 200


@pytest.fixture
def built(tmp_path):
    """A page as Vite builds it."""
    static = tmp_path / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<title>the page</title>", "utf-8")
    (static / "icon.svg").write_text("<svg/>", "utf-8")
    (static / "assets" / "index-1a2b3c.js").write_text(SCRIPT, "utf-8")
    return static


def get(server, path, **headers):
    return server.get(path, Cookie=f"learnblock_token={TOKEN}", **headers)


def test_the_root_is_the_page(server, built):
    response = server.get(f"/?token={TOKEN}")
    assert response.body == b"<title>the page</title>"
    assert response.headers["Cache-Control"] == "no-store"


def test_without_a_built_page_instructions_to_build_it_are_shown(server):
    response = server.get(f"/?token={TOKEN}")
    assert response.status == 503
    assert b"npm run build" in response.body


def test_hashed_files_are_cached_permanently(server, built):
    assert "immutable" in server.get("/assets/index-1a2b3c.js").headers["Cache-Control"]


def test_other_files_are_revalidated(server, built):
    assert server.get("/icon.svg").headers["Cache-Control"] == "no-cache"


def test_files_are_sent_compressed(server, built):
    response = server.get("/assets/index-1a2b3c.js", **{"Accept-Encoding": "gzip"})
    assert response.headers["Content-Encoding"] == "gzip"
    assert gzip.decompress(response.body).decode() == SCRIPT


def test_precompressed_files_are_sent_to_browsers_that_accept_them(server, built):
    (built / "assets" / "index-1a2b3c.js.br").write_bytes(b"packed")
    response = server.get("/assets/index-1a2b3c.js", **{"Accept-Encoding": "gzip, br;q=0.9"})
    assert response.headers["Content-Encoding"] == "br"
    assert response.headers["Content-Type"].startswith("text/javascript")
    assert "immutable" in response.headers["Cache-Control"]
    assert response.body == b"packed"
    response = server.get("/assets/index-1a2b3c.js", **{"Accept-Encoding": "gzip"})
    assert response.headers["Content-Encoding"] == "gzip"


@pytest.mark.parametrize("path", ["/..%2fprojects", "/assets/../../secret", "/nothing.js"])
def test_nothing_but_the_page_is_served(server, built, path):
    (built.parent / "secret").write_text("secret", "utf-8")
    assert server.get(path).status == 404


def test_the_help_of_a_block_has_an_example_with_the_blocks_that_ran(server):
    shown = json.loads(get(server, "/help/controls_repeat_ext.json").body)
    blocks = {text for _, kind, text in shown["events"] if kind == "line"}
    assert shown["program"].startswith("main:\n    repeat 4:")
    assert len(blocks - {""}) == len(blocks) >= 3
    assert len(shown["way"]) > 5


def test_a_block_without_an_example_has_no_moving_picture(server):
    assert get(server, "/help/function.my_own.json").status == 404


def test_a_program_in_block_text_is_sent_as_blocks(server):
    text = quote("main:\n    function.turn(90)\nend")
    [[main]] = json.loads(get(server, f"/drawn.json?text={text}").body)["stacks"]
    assert main["type"] == "lb_main"
    assert main["inputs"]["DO"]["stack"][0]["type"] == "lb_skill_turn"


@pytest.mark.parametrize("text", ["main:\n    turn(\nend", "x = 1\n" * 1000])
def test_a_text_with_a_mistake_or_of_many_lines_has_no_blocks(server, text):
    assert get(server, f"/drawn.json?text={quote(text)}").status == 404


def test_the_palette_is_cached_until_it_changes(server):
    first = get(server, "/palette/es.json")
    assert json.loads(first.body)["language"] == "es"
    again = get(server, "/palette/es.json", **{"If-None-Match": first.headers["ETag"]})
    assert (again.status, again.body) == (304, b"")


def test_the_palette_of_an_unknown_language_is_english(server):
    english = json.loads(get(server, "/palette/en.json").body)
    unknown = json.loads(get(server, "/palette/tlh.json").body)
    assert unknown["messages"] == english["messages"]


@pytest.mark.parametrize("path", ["/textures/tag/7.png", "/textures/face/joy.png"])
def test_tags_and_faces_are_pictures(server, path):
    response = get(server, path)
    assert response.headers["Content-Type"] == "image/png"
    assert response.body.startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "path",
    [
        "/textures/tag/100000.png",
        "/textures/tag/-1.png",
        "/textures/face/wrath.png",
        "/worlds/empty/floor.png",
        "/worlds/nowhere/floor.png",
        "/worlds/..%2f..%2fetc%2fpasswd/floor.png",
    ],
)
def test_a_missing_picture_is_not_found(server, path):
    assert get(server, path).status == 404


def test_everything_is_below_the_base_address(projects, built):
    with serving(projects, static=built, base_url="/robots/") as server:
        assert server.get(f"/robots/?token={TOKEN}").body == b"<title>the page</title>"
        assert "Path=/robots/" in server.get(f"/robots/?token={TOKEN}").headers["Set-Cookie"]
        assert server.get("/robots/icon.svg").status == 200
        assert server.get("/robots").headers["Location"].endswith("/robots/")
        assert server.get("/icon.svg").status == 404
