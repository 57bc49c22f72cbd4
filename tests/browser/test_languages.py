"""Another language: at once, everywhere, and back again."""

import json
import re
from functools import cache
from pathlib import Path

import pytest
from playwright.sync_api import expect

from learnblock.language.library import BUILTINS, TEMPLATES

ROOT = Path(__file__).parents[2]
WORDS = ROOT / "frontend/src/i18n"
BLOCKS = ROOT / "src/learnblock/blocks/translations"
#: Whose names are the same in both languages.
PROGRAM = """\
# 1
x = [1, 2]

def f(a):
    while not function.is_tag(a):
        function.turn_right(20)
    end
    if a > 1:
        append(x, a)
    else:
        function.stop_bot()
    end
end

when w = x == 2:
    function.expressJoy()
end

main:
    for i in x:
        f(i)
    end
    print("1")
end
"""
#: The height of a button, in pixels.
BUTTON = 40
WRONG = "main:\n    while\nend\n"
FAILING = "main:\n    x = 1 / 0\nend\n"
#: What is called the same everywhere: robots, notations, units, keys, what is no word at all.
NAMES = re.compile(
    r"EBO|Cozmo|Thymio II|LEGO EV3|LearnBlock|Python|Block-Text|English|Español"
    r"|[\d\W]*|.*[×°²]|(Ctrl|Shift|Alt)\+.*|F\d+|Enter|Esc.*|Delete|[a-zA-Z]\d?|Y:|sin|π"
)
#: On the blocks that call them.
FUNCTIONS = {*BUILTINS, *(name for name, _ in TEMPLATES), "world ="}
DIALOGS = {
    "open": ("project", 1),
    "examples": ("project", 2),
    "save as": ("project", 3),
    "history": ("project", 4),
    "blocks shown": ("project", 5),
    "names of tags": ("project", 8),
    "delete": ("project", 13),
    "tour": ("help", 0),
    "settings": ("help", 1),
    "keys": ("help", 3),
    "settings of robots": ("help", 4),
    "perception": ("help", 5),
}
MENUS = {
    "project": ".project-group .menu button",
    "help": ".page-group .menu:nth-of-type(3) button",
}


@pytest.fixture
def pupil(sit_down, server):
    """Before a program with many sorts of blocks."""
    pupil = sit_down(server, viewport={"width": 1600, "height": 900})
    pupil.begin()
    pupil.write("blocktext", PROGRAM)
    expect(pupil.blocks("lb_when")).to_be_visible()
    pupil.is_saved()
    return pupil


def test_the_whole_page_is_spanish_at_once_and_english_again(pupil):
    english = texts(pupil)
    speak(pupil, "Español")
    pupil.robot_is("Mundo: Un suelo vacío")
    pupil.picture("spanish")
    assert left_over(english, texts(pupil)) == set()
    assert pupil.page.locator("html").get_attribute("lang") == "es"
    assert pupil.page.locator("header").bounding_box()["height"] < 2 * BUTTON
    speak(pupil, "English")
    assert texts(pupil) == english


def test_every_category_of_the_palette_speaks_spanish(pupil):
    english = palette(pupil)
    speak(pupil, "Español")
    spanish = palette(pupil)
    pupil.picture("palette")
    assert len(english) == len(spanish) > 20
    assert left_overs(english, spanish) == {}


def test_every_dialog_speaks_spanish(pupil):
    english = {name: dialog(pupil, *menu) for name, menu in DIALOGS.items()}
    speak(pupil, "Español")
    spanish = {name: dialog(pupil, *menu) for name, menu in DIALOGS.items()}
    assert left_overs(english, spanish) == {}


def test_the_world_editor_speaks_spanish(pupil):
    english = world_editor(pupil)
    speak(pupil, "Español")
    assert left_over(english, world_editor(pupil)) == set()


def test_a_run_is_shown_and_told_in_spanish(pupil):
    pupil.write("blocktext", FAILING)
    expect(pupil.blocks("lb_when")).to_have_count(0)
    speak(pupil, "Español")
    for tab in ("Consola", "Variables", "Sensores", "Problemas", "Resultado"):
        pupil.tab(tab)
    pupil.press("Ejecutar")
    expect(pupil.page.get_by_role("alert").filter(has_text="Detenido por un error")).to_have_text(
        re.compile("No se puede dividir entre cero")
    )
    expect(pupil.page.locator(".result dl")).to_be_visible()
    pupil.picture("result")
    assert english_words() & texts(pupil) == set()


def test_a_mistake_is_explained_in_the_language_that_is_chosen(pupil):
    pupil.write("blocktext", WRONG)
    problems = pupil.tab("Problems")
    expect(problems).to_contain_text("this `while` does nothing: write `pass`")
    speak(pupil, "Español")
    problems = pupil.tab("Problemas")
    expect(problems).to_contain_text("este `while` no hace nada: escribe `pass`")
    expect(problems).to_contain_text("aquí hace falta un valor detrás de `while`, no el final")
    pupil.picture("problems")
    pupil.page.locator(".cm-lint-marker-error").first.hover()
    expect(pupil.page.locator(".cm-tooltip")).to_contain_text("este `while` no hace nada")


def test_what_the_server_refuses_is_explained_in_spanish(pupil, tmp_path):
    file = tmp_path / "roto.learnblock"
    file.write_text("{ no JSON")
    speak(pupil, "Español")
    with pupil.page.expect_file_chooser() as chooser:
        pupil.project("Subir un archivo…")
    chooser.value.set_files(file)
    pupil.told("esto no es JSON")
    pupil.picture("refused")


def test_the_search_for_blocks_understands_and_speaks_spanish(pupil):
    speak(pupil, "Español")
    search = pupil.page.get_by_role("searchbox", name="Buscar bloques")
    search.fill("girar a la der")
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_turn_right")).to_be_visible()
    told = pupil.page.get_by_role("status").filter(has_text="Bloques que coinciden: 1")
    expect(told).to_have_count(1)
    pupil.picture("search")
    search.fill("xyzxyz")
    expect(pupil.page.locator(".blocklyFlyout:visible")).to_contain_text(
        "No hay bloques que coincidan"
    )


def speak(pupil, language):
    """Choose a language; wait until the last ones, the blocks, speak it."""
    pupil.page.locator(".page-group .menu button").first.click()
    pupil.page.get_by_role("menuitemradio", name=language).click()
    word = {"English": "main program", "Español": "programa principal"}[language]
    expect(pupil.blocks("lb_main").first).to_contain_text(word)


def dialog(pupil, menu, number):
    """The words of a dialog, which is then closed again."""
    pupil.page.locator(MENUS[menu]).first.click()
    pupil.page.get_by_role("menuitem").nth(number).click()
    expect(pupil.dialog()).to_be_visible()
    found = texts(pupil, "dialog")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def world_editor(pupil):
    """The words of the world editor with a box, which is then left again."""
    pupil.page.locator(".choice-with-button button").click()
    pupil.dialog().locator("[data-sort=box]").click()
    expect(pupil.dialog().locator("[data-key=height]")).to_be_visible()
    found = texts(pupil, "dialog")
    pupil.picture(f"editor-{len(found)}")
    pupil.page.keyboard.press("Escape")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def palette(pupil):
    """For each category, by its number, the words of its blocks."""
    rows = pupil.page.locator(".blocklyToolboxCategory:not(:has(input))")
    found = {}
    for number, row in enumerate(rows.all()):
        row.click()
        found[number] = {row.text_content(), *texts(pupil, ".blocklyFlyout")}
    pupil.page.keyboard.press("Escape")
    return found


def texts(pupil, part="body"):
    """Every text of a part of the page: words, labels, tooltips; not the program's own."""
    found = pupil.page.evaluate(
        """(part) => {
            const own = "canvas, .cm-content, .blocklyInputField, .project-name, .world-said, "
                + ".found, .rows strong, option, script, style";
            const found = new Set();
            const add = (text) => text?.trim() && found.add(text.replace(/\\s+/g, " ").trim());
            for (const root of document.querySelectorAll(part)) {
                for (const element of [root, ...root.querySelectorAll("*")]) {
                    if (element.closest(own) || !element.checkVisibility()) continue;
                    for (const node of element.childNodes) {
                        if (node.nodeType === Node.TEXT_NODE) add(node.data);
                    }
                    for (const name of ["aria-label", "title", "placeholder"]) {
                        add(element.getAttribute(name));
                    }
                }
            }
            return [...found];
        }""",
        part,
    )
    return set(found)


def left_over(english, spanish):
    """What is called the same in both, and has no reason to be."""
    same = english & spanish - same_words() - FUNCTIONS
    return {one for one in same if not NAMES.fullmatch(one)}


def left_overs(english, spanish):
    """The same for several parts, by their names; only those that have something."""
    found = {name: left_over(english[name], spanish[name]) for name in english}
    return {name: words for name, words in found.items() if words}


@cache
def words(language):
    """All words of the page and of our blocks, by their keys."""
    files = [*(WORDS / language).glob("*.json"), BLOCKS / f"{language}.json"]
    return {
        f"{file.stem}.{key}" if file.parent.name == language else key: text
        for file in files
        for key, text in json.loads(file.read_text("utf-8")).items()
    }


@cache
def same_words():
    """What both languages write the same, such as `Control`."""
    spanish = words("es")
    same = {text for key, text in words("en").items() if spanish[key] == text}
    return same | {text.partition("%")[0].strip() for text in same}


@cache
def english_words():
    return set(words("en").values()) - set(words("es").values())
