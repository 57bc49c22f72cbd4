"""The order of a program in blocks is the one that is drawn, and blocks go from tab to tab."""

import pytest
from playwright.sync_api import expect

EVENTS = "when a = True:\n    pass\nend\n\nwhen b = True:\n    pass\nend\n"
USES = """def spin():
    function.turn(90)
end

start = 0

main:
    spin()
end
"""
NEW = "when b = True:\n    pass\nend\n\nwhen c = True:\n    pass\nend\n\n"


@pytest.fixture
def empty(sit_down, server):
    """A pupil with an empty program in blocks and Block-Text."""
    pupil = sit_down(server, empty=True, flat=True)
    pupil.show("Blocks", "Block-Text")
    return pupil


def drawn(pupil):
    """The names of the events from top to bottom."""
    hats = pupil.blocks("lb_when").all()
    return "".join(
        hat.locator(".blocklyInputField").first.text_content()
        for hat in sorted(hats, key=lambda one: one.bounding_box()["y"])
    )


def written(pupil):
    """The names of the events in Block-Text."""
    return "".join(line[5] for line in pupil.text("blocktext").splitlines() if line[:4] == "when")


def test_an_event_that_is_dragged_above_another_comes_first(empty):
    empty.write("blocktext", EVENTS)
    expect(empty.blocks("lb_when")).to_have_count(2)
    first, second = empty.blocks("lb_when").all()
    box = first.locator("> .blocklyPath").first.bounding_box()
    lower = second if "b" in second.text_content() else first
    empty._drag(lower, (box["x"] + 60, max(box["y"] - 60, 5)))
    empty.sees("blocktext", "when b = True:", "    pass", "end", "", "when a = True:")
    empty.picture("dragged")


def test_events_are_drawn_in_the_order_of_the_text_after_each_change_of_it(empty):
    empty.write("blocktext", EVENTS)
    expect(empty.blocks("lb_when")).to_have_count(2)
    assert "ab" == drawn(empty) == written(empty)
    empty.write("blocktext", NEW + EVENTS[: EVENTS.index("when b")])
    expect(empty.blocks("lb_when")).to_have_count(3)
    assert "bca" == drawn(empty) == written(empty)
    empty.picture("changed")


def test_blocks_copied_in_one_tab_are_pasted_in_another(empty):
    empty.write("blocktext", EVENTS)
    first = empty.page
    empty.select_block(empty.blocks("lb_when").first)
    first.keyboard.press("Control+c")
    first.evaluate("dispatchEvent(new Event('blur'))")  # as when another tab comes to the front
    empty.page = empty.open(first.url)
    expect(empty.blocks("lb_when")).to_have_count(2)
    empty.page.locator(".blocklyMainBackground").first.click(position={"x": 300, "y": 300})
    empty.page.keyboard.press("Control+v")
    expect(empty.blocks("lb_when")).to_have_count(3)


@pytest.mark.parametrize("size", [(1366, 768), (390, 844)])
def test_main_is_in_sight_above_functions_when_a_project_opens_and_after_an_edit(
    sit_down, server, size
):
    pupil = sit_down(
        server,
        empty=True,
        stage="starter",
        viewport={"width": size[0], "height": size[1]},
    )

    def switch(view):
        return pupil.page.locator(".areas").get_by_role("button", name=view, exact=True)

    switch("Block-Text").click()
    pupil.write("blocktext", USES.replace("spin():\n", "spin():\n" + "    function.turn(9)\n" * 9))
    pupil.wait_until_saved()
    pupil.page.reload()
    switch("Blocks").click()
    expect(pupil.blocks("procedures_defnoreturn")).to_have_count(1)
    expect_main_first(pupil)
    pupil.picture(f"opened-{size[0]}")
    switch("Block-Text").click()
    pupil.write("blocktext", USES.replace("main:", f"{NEW}main:"))
    switch("Blocks").click()
    expect(pupil.blocks("lb_when")).to_have_count(2)
    expect_main_first(pupil)
    pupil.picture(f"changed-{size[0]}")


def expect_main_first(pupil):
    """Check that `main` is in sight above all definitions."""
    main = pupil.blocks("lb_main")
    expect(main).to_be_in_viewport(ratio=0.9)
    others = pupil.blocks("procedures_defnoreturn").or_(pupil.blocks("lb_when")).all()
    assert main.bounding_box()["y"] < min(one.bounding_box()["y"] for one in others)
