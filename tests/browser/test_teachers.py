"""What the start page has for teachers: a class that is opened, seen and closed with buttons."""

import re

from playwright.sync_api import expect

from browser.test_class import button, join


def go_to_teachers(sit_down, server, **options):
    teacher = sit_down(server, start=True, flat=True, **options)
    button(teacher.page, "For teachers").click()
    return teacher


def test_a_class_is_started_with_a_button_and_its_lesson_waits_for_the_pupils(
    own_server, sit_down, desk
):
    teacher = go_to_teachers(sit_down, own_server)
    page = teacher.page
    name = page.get_by_label("Name, such as 7b")
    expect(name).to_be_focused()
    page.keyboard.type("7b")
    page.get_by_label("First lesson").select_option("Turn a corner")
    with teacher.context.expect_page() as opened:
        page.keyboard.press("Enter")
    wall = opened.value
    expect(wall.get_by_role("heading", name="Class 7b")).to_be_visible()
    word = wall.locator(".join-word").inner_text()
    child, _ = join(desk, wall.url.removesuffix("/teacher"), word, "Ana")
    expect(child.get_by_text("Turn a corner").first).to_be_visible()
    # It asks the class for the text's code, which is gone when the class is closed.
    expect(child.locator(".lesson-text")).to_be_visible()
    teacher.picture("teachers")
    button(page, "Close").click()
    expect(page.get_by_text("1 pupil · last used today")).to_be_visible()
    button(page, "Open").click()
    expect(page.get_by_role("link", name="Go to the wall")).to_be_visible()
    button(page, "Close").click()
    button(page, "More for 7b").click()
    page.get_by_role("menuitem", name="Delete").click()
    page.keyboard.type("7b")
    page.keyboard.press("Enter")
    expect(page.get_by_text("Your classes appear here")).to_be_visible()


def test_a_class_that_can_not_have_its_name_says_so_beside_it(own_server, sit_down):
    teacher = go_to_teachers(sit_down, own_server)
    teacher.page.get_by_label("Name, such as 7b").fill("7b/../x")
    button(teacher.page, "Start class").click()
    expect(teacher.page.get_by_role("alert").filter(has_text="The name of a class")).to_be_visible()


def test_teachers_are_told_what_learnblock_grade_does(own_server, sit_down):
    teacher = go_to_teachers(sit_down, own_server)
    button(teacher.page, "What learnblock grade does").click()
    expect(teacher.dialog()).to_contain_text("No mark is final")
    expect(teacher.dialog()).to_contain_text("learnblock grade class-7b --lesson 1-03-square")
    teacher.dialog().get_by_role("button", name="Back").click()
    expect(teacher.dialog()).to_have_count(0)


def test_the_start_page_is_one_click_away_from_what_is_for_teachers(own_server, sit_down):
    teacher = go_to_teachers(sit_down, own_server)
    expect(button(teacher.page, "For teachers")).to_have_attribute("aria-current", "page")
    button(teacher.page, "Examples").click()
    expect(teacher.page.locator("#examples")).to_be_focused()
    expect(teacher.page.get_by_role("heading", name=re.compile("Start a class"))).to_have_count(0)
