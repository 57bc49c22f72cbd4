"""axe finds nothing in any state of the page, whatever its impact, in any theme.

And no dialog is beyond the window, where it could not be scrolled to, and no id is there twice.
"""

import re

import pytest

from browser import states

THEMES = ("light", "dark", "contrast")
SIZES = {"wide": (1366, 768), "tablet": (820, 1180), "phone": (390, 844)}
#: What else differs is their colours.
COLOURS = ["color-contrast"]
#: The names of the open dialogs that are partly outside the window.
BEYOND = """() => [...document.querySelectorAll("dialog[open]")]
    .filter((one) => {
        const { left, top, right, bottom } = one.getBoundingClientRect();
        return left < 0 || top < 0 || right > innerWidth || bottom > innerHeight;
    })
    .map((one) => one.querySelector("h2")?.textContent)"""
#: The ids that several elements have.
DOUBLE = """() => {
    const ids = [...document.querySelectorAll("[id]")].map((one) => one.id);
    return [...new Set(ids.filter((id, at) => ids.indexOf(id) !== at))];
}"""
RUN_AXE = """([theme, rules]) => {
    document.documentElement.dataset.theme = theme;
    const runOnly = rules ? { runOnly: rules } : {};
    return axe.run(document, { resultTypes: ["violations"], ...runOnly });
}"""


@pytest.fixture
def visit(sit_down, axe):
    """A function that walks through states; it returns what axe finds in each."""

    def visit(walk, server, size="wide", language="en", **options):
        width, height = SIZES[size]
        pupil = sit_down(
            server,
            language=language,
            viewport={"width": width, "height": height},
            has_touch=size != "wide",
            # Colours that change slowly are measured on the way.
            reduced_motion="reduce",
            **options,
        )
        found = []
        for state in walk(states.Visitor(pupil, language)):
            pupil.picture(f"{language}-{size}-{state}")
            found += [(state, "beyond the window", one) for one in pupil.page.evaluate(BEYOND)]
            found += [(state, "double id", one) for one in pupil.page.evaluate(DOUBLE)]
            found += [(state, *fault) for fault in faults(pupil.page, axe, THEMES)]
        return found

    return visit


@pytest.mark.parametrize("walk", states.WALKS)
def test_no_state_of_the_working_page_has_a_violation(visit, server, walk):
    assert visit(walk, server, empty=True, stage="starter") == []


@pytest.mark.parametrize("size", ["tablet", "phone"])
@pytest.mark.parametrize("walk", [states.views, states.menus, states.mistakes, states.connecting])
def test_no_state_on_a_small_screen_has_a_violation(visit, server, walk, size):
    assert visit(walk, server, size, empty=True, stage="starter") == []


@pytest.mark.parametrize("walk", [states.filled_dialogs, states.world_editor])
def test_no_large_dialog_on_a_tablet_has_a_violation(visit, server, walk):
    assert visit(walk, server, "tablet", empty=True, stage="starter") == []


@pytest.mark.parametrize("walk", [states.runs, states.extras])
def test_no_state_with_the_buttons_of_the_debugger_has_a_violation(visit, server, walk):
    assert visit(walk, server, empty=True, stage="coder") == []


@pytest.mark.parametrize("walk", [states.views, states.menus, states.connecting])
def test_no_state_in_spanish_has_a_violation(visit, server, walk):
    assert visit(walk, server, language="es", empty=True, stage="starter") == []


@pytest.mark.parametrize("size", SIZES)
def test_no_state_of_the_start_page_has_a_violation(visit, own_server, size):
    found = visit(states.start_page, own_server, size, start=True)
    own_server.address_of_new_project()
    assert found + visit(states.start_page_with_projects, own_server, size, start=True) == []


def faults(page, axe, themes):
    """Return the violations in themes: the theme, the rule, the element and the cause."""
    page.evaluate(f"() => {{ if (!globalThis.axe) {{ {axe} }} }}")
    before = page.evaluate("document.documentElement.dataset.theme")
    found = []
    for theme in themes:
        rules = None if theme == THEMES[0] else COLOURS
        for fault in page.evaluate(RUN_AXE, [theme, rules])["violations"]:
            causes = [(one["target"], one["failureSummary"]) for one in fault["nodes"]]
            found += [(theme, fault["id"], at, re.sub(r"\s+", " ", why)) for at, why in causes]
    page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", before)
    return found
