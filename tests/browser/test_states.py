"""axe finds nothing in any state of the page, whatever its impact, in any theme and size.

And no dialog is beyond the window, where it could not be scrolled to, no id is there twice, and on
a tablet and a phone a finger hits everything.
"""

import re

import pytest

import small_lesson
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
#: What a finger has to hit and is shorter than 44 px on a side. A box beside words is hit by them
#: too, a link in a sentence has the height of the sentence, the size of a block is its renderer's,
#: and black keys are as narrow as on every piano.
SMALL = """() => {
    const all = "button, select, input, textarea, a[href], summary, [role=tab], [role^=menuitem],"
        + " [role=option], [role=switch], [role=slider], .blocklyToolboxCategory, .blocklyMenuItem";
    const hit = (one) => one.matches("[type=checkbox], [type=radio], [type=file]")
        ? (one.closest("label") ?? one) : one;
    return [...document.querySelectorAll(all)]
        .filter((one) => hit(one).checkVisibility({ visibilityProperty: true }))
        .filter((one) => one instanceof HTMLElement)
        .filter((one) => !one.matches(":disabled, .blocklyHtmlInput, .lbBlackKey, .skip-links *"))
        .filter((one) => !one.closest("[inert], [aria-hidden=true]"))
        .filter((one) => getComputedStyle(one).pointerEvents !== "none")
        .filter((one) => !(one.matches("a") && getComputedStyle(one).display === "inline"))
        .map((one) => [one, hit(one).getBoundingClientRect()])
        .filter(([, { width, height }]) => width && height)
        .filter(([, { width, height }]) => Math.min(width, height) < 43.9)
        .map(([one, { width, height }]) => {
            const name = one.ariaLabel || one.textContent.trim() || one.className || one.id;
            const place = one.closest("[class]")?.className;
            return `${one.tagName} ${place} "${name}" ${width.toFixed(1)}x${height.toFixed(1)}`;
        });
}"""
#: The list of suggestions is scrolled with the arrow keys of the text, which keeps the focus: axe
#: knows that only of a combobox.
RUN_AXE = """([theme, rules]) => {
    document.documentElement.dataset.theme = theme;
    const runOnly = rules ? { runOnly: rules } : {};
    axe.configure({ rules: [{
        id: "scrollable-region-focusable",
        selector: "*:not(.cm-tooltip-autocomplete > ul)",
    }] });
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
            if size != "wide":
                found += [(state, "too small", one) for one in pupil.page.evaluate(SMALL)]
            found += [(state, *fault) for fault in faults(pupil.page, axe, THEMES)]
        return found

    return visit


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("walk", states.WALKS)
def test_no_state_of_the_working_page_has_a_fault(visit, server, walk, size):
    stage = "explorer" if walk in states.EXPLORED else "starter"
    flat = walk not in states.BESIDE_THE_WORLD
    assert visit(walk, server, size, empty=True, stage=stage, flat=flat) == []


@pytest.mark.parametrize("size", SIZES)
def test_no_state_of_a_lesson_has_a_fault(visit, own_server, size):
    small_lesson.put_in(own_server.home)
    assert visit(states.lesson, own_server, size, start=True) == []


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
