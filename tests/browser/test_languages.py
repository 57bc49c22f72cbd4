"""Changing the language of the whole page and back."""

import json
import re
from functools import cache

import pytest
from playwright.sync_api import expect

from browser.pupil import MORE
from learnblock.language.tree.builtins import BUILTINS, TEMPLATES
from places import ROOT

WORDS = ROOT / "src/learnblock/i18n"
WORD = re.compile(r"^(page-[\w-]+) = (.+)$", re.MULTILINE)
BLOCKS = ROOT / "src/learnblock/blocks/translations"
#: A program whose names are the same in both languages.
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
#: Texts that are the same in every language: robots, notations, units, keys, symbols.
NAMES = re.compile(
    r"EBO|Cozmo|Thymio II|LEGO EV3|LearnBlock|Python|Block-Text|English|Español"
    r"|[\d\W]*|.*[×°²]|(°|mm|ms|s)(\s?/\s?s)?[?,]?|(Ctrl|Shift|Alt)\+.*|F\d+|Enter|Esc.*|Delete|[a-zA-Z]\d?|Y:|sin|π"
    r"|learnblock .*|mm, y|F1, Ctrl\+I"
)
#: Names shown on the blocks that call these functions.
FUNCTIONS = {*BUILTINS, *(name for name, _ in TEMPLATES), "world ="}
#: Each dialog by its menu, or by the dialog *More…* of a project, and the number of its command.
DIALOGS = {
    "new": ("project", 0),
    "open": ("project", 1),
    "examples": ("project", 2),
    "rename": ("project", 3),
    "save as": ("project", 4),
    "history": ("project", 5),
    "more": ("project", 7),
    "delete": ("project", 8),
    "block sets": ("rare", 0),
    "my blocks": ("rare", 1),
    "libraries": ("rare", 2),
    "tag names": ("rare", 3),
    "make a lesson": ("rare", 4),
    "open a link": ("rare", 5),
    "help": ("more", 0),
    "shortcuts": ("more", 2),
    "other device": ("more", 3),
    "settings": ("more", 4),
    "robot settings": ("robot", 1),
}
MENUS = {
    "project": "header .title",
    "more": "header > .menu:last-child > button",
    "robot": "header .pill",
}


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a program of many types of blocks."""
    pupil = sit_down(server, viewport={"width": 1600, "height": 900}, empty=True)
    # Lines that the program of another project has left there stay as they were written.
    pupil.tab("Console").get_by_role("button", name="Clear").click()
    pupil.write("blocktext", PROGRAM)
    expect(pupil.blocks("lb_when")).to_be_visible()
    pupil.wait_until_saved()
    # The help of the word below the mouse is no part of the page.
    pupil.page.mouse.move(1, 1)
    expect(pupil.page.locator(".cm-tooltip-hover")).to_have_count(0)
    return pupil


def test_the_whole_page_changes_to_spanish_and_back_to_english(pupil):
    english = visible_texts(pupil)
    choose_language(pupil, "Español")
    pupil.expect_robot("Mundo: Un suelo vacío")
    pupil.picture("spanish")
    assert untranslated(english, visible_texts(pupil)) == set()
    assert pupil.page.locator("html").get_attribute("lang") == "es"
    assert pupil.page.locator("header").bounding_box()["height"] < 2 * BUTTON
    choose_language(pupil, "English")
    assert visible_texts(pupil) == english


def test_every_category_of_the_palette_is_translated(pupil):
    english = palette(pupil)
    choose_language(pupil, "Español")
    spanish = palette(pupil)
    pupil.picture("palette")
    assert len(english) == len(spanish) == 9
    assert untranslated_parts(english, spanish) == {}


def test_every_dialog_is_translated(pupil):
    english = {name: dialog(pupil, *menu) for name, menu in DIALOGS.items()}
    choose_language(pupil, "Español")
    spanish = {name: dialog(pupil, *menu) for name, menu in DIALOGS.items()}
    assert untranslated_parts(english, spanish) == {}


def test_the_world_editor_is_translated(pupil):
    english = world_editor(pupil)
    choose_language(pupil, "Español")
    assert untranslated(english, world_editor(pupil)) == set()


def test_a_run_is_shown_and_read_out_in_spanish(pupil):
    pupil.write("blocktext", FAILING)
    expect(pupil.blocks("lb_when")).to_have_count(0)
    choose_language(pupil, "Español")
    for tab in ("Consola", "Variables", "Sensores", "Problemas", "Resultado"):
        pupil.tab(tab)
    pupil.press("Ejecutar")
    expect(pupil.page.get_by_role("alert").filter(has_text="Detenido por un error")).to_have_text(
        re.compile("Se ha dividido un número entre 0")
    )
    expect(pupil.page.locator(".result dl")).to_be_visible()
    pupil.picture("result")
    assert english_words() & visible_texts(pupil) == set()


def test_the_page_s_own_lines_in_the_console_change_their_language(pupil):
    pupil.write("blocktext", FAILING)
    expect(pupil.blocks("lb_when")).to_have_count(0)
    pupil.press("Run")
    console = pupil.tab("Console")
    expect(console).to_contain_text("Stopped by an error")
    choose_language(pupil, "Español")
    console = pupil.page.locator(".console-lines")
    expect(console).to_contain_text("Detenido por un error")
    expect(console).not_to_contain_text("Stopped by an error")
    expect(console.locator(".run").last).to_contain_text("Ejecución 1")


def test_a_mistake_is_explained_in_the_chosen_language(pupil):
    pupil.write("blocktext", WRONG)
    problems = pupil.tab("Problems")
    expect(problems).to_contain_text("This 'while' is empty. Write 'pass'")
    choose_language(pupil, "Español")
    problems = pupil.tab("Problemas")
    expect(problems).to_contain_text("Este 'while' está vacío. Escribe 'pass'")
    expect(problems).to_contain_text("Aquí hace falta un valor después de 'while', no el final")
    pupil.picture("problems")
    pupil.page.locator(".cm-lint-marker-error").first.hover()
    expect(pupil.page.locator(".cm-tooltip")).to_contain_text("Este 'while' está vacío")


def test_a_refusal_by_the_server_is_explained_in_spanish(pupil, tmp_path):
    file = tmp_path / "roto.learnblock"
    file.write_text("{ no JSON")
    choose_language(pupil, "Español")
    with pupil.page.expect_file_chooser() as chooser:
        pupil.project("Subir archivos…")
    chooser.value.set_files(file)
    pupil.expect_note("Este archivo está dañado o no es un proyecto de LearnBlock")
    pupil.picture("refused")


def test_the_search_for_blocks_works_in_spanish(pupil):
    choose_language(pupil, "Español")
    pupil.search_blocks("girar sin parar a la der")
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_turn_right")).to_be_visible()
    status = pupil.page.get_by_role("status").filter(has_text="1 bloque encontrado")
    expect(status).to_have_count(1)
    pupil.picture("search")
    pupil.page.get_by_role("searchbox", name="Buscar bloques").fill("xyzxyz")
    expect(pupil.page.locator(".blocklyFlyout:visible")).to_contain_text(
        "No hay bloques que coincidan"
    )


def choose_language(pupil, language):
    """Choose a language; wait until the blocks, which change last, are in it."""
    pupil.page.locator(MENUS["more"]).click()
    pupil.page.get_by_role("menuitemradio", name=language).click()
    word = {"English": "when Run is pressed", "Español": "al pulsar Ejecutar"}[language]
    expect(pupil.blocks("lb_main").first).to_contain_text(word)


def dialog(pupil, menu, number):
    """Open a dialog, return its texts, and close it."""
    if menu == "rare":
        pupil.project(MORE)
        pupil.dialog().locator(".rows button").nth(number).click()
    else:
        pupil.page.locator(MENUS[menu]).first.click()
        pupil.page.get_by_role("menuitem").nth(number).click()
    expect(pupil.dialog()).to_be_visible()
    found = visible_texts(pupil, "dialog")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def world_editor(pupil):
    """Open the world editor with a box, return its texts, and close it."""
    pupil.page.locator(".world-menu button").click()
    pupil.page.get_by_role("menuitem").nth(1).click()
    pupil.dialog().locator("[data-sort=box]").click()
    pupil.page.keyboard.press("Enter")
    pupil.dialog().locator(".editor-more summary").click()
    expect(pupil.dialog().locator("[data-key=height]")).to_be_visible()
    found = visible_texts(pupil, "dialog")
    pupil.picture(f"editor-{len(found)}")
    pupil.page.keyboard.press("Escape")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def palette(pupil):
    """Return the texts of the blocks in each category, by its number."""
    rows = pupil.page.locator(".blocklyToolboxCategory:has(.lbGroupIcon):visible")
    found = {}
    for number, row in enumerate(rows.all()):
        row.click()
        pupil.show_more_blocks()
        found[number] = {row.text_content(), *visible_texts(pupil, ".blocklyFlyout")}
    pupil.page.keyboard.press("Escape")
    return found


def visible_texts(pupil, part="body"):
    """Return all texts, labels and tooltips in a part of the page, except the program's."""
    found = pupil.page.evaluate(
        """(part) => {
            const own = "canvas, .cm-content, .blocklyInputField, .project-name, .world-said, "
                + ".found, .rows strong, .chip b, option, script, style";
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


def untranslated(english, spanish):
    """Return the texts that are equal in both languages without a reason."""
    same = english & spanish - same_words() - FUNCTIONS
    return {one for one in same if not NAMES.fullmatch(one)}


def untranslated_parts(english, spanish):
    """Return the untranslated texts of several parts by name, without empty ones."""
    found = {name: untranslated(english[name], spanish[name]) for name in english}
    return {name: words for name, words in found.items() if words}


@cache
def words(language):
    """Return all texts of the page and of the blocks, by their codes."""
    files = sorted((WORDS / language / "page").glob("*.ftl"))
    page = {code: text for file in files for code, text in WORD.findall(file.read_text("utf-8"))}
    return page | json.loads((BLOCKS / f"{language}.json").read_text("utf-8"))


@cache
def same_words():
    """Return the texts that are the same in both languages, such as `Control`."""
    spanish = words("es")
    same = {text for key, text in words("en").items() if spanish[key] == text}
    return same | {text.partition("%")[0].strip() for text in same}


@cache
def english_words():
    return set(words("en").values()) - set(words("es").values())
