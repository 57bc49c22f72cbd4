"""Lessons that come with LearnBlock, from the start page to the last star."""

import re

from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN, SPEEDS
from browser.typist import Typist
from learnblock.lessons.puzzles import right_orders
from learnblock.lessons.reading import find_lesson

PHONE = {"width": 390, "height": 844}


class Player:
    """A pupil who knows the answers of a lesson, and uses the page with the mouse.

    Args:
        pupil: the pupil.
        name: the name of the lesson.
    """

    def __init__(self, pupil, name):
        self.pupil, self.page = pupil, pupil.page
        self.opened = find_lesson(name)
        self.title = self.opened.lesson.title["en"]

    def play(self):
        """Earn every star of every step, and finish."""
        self.open()
        steps = self.opened.lesson.step
        for number, step in enumerate(steps, 1):
            expect(self.panel()).to_contain_text(f"Step {number} of {len(steps)}")
            self.take_step(number, step)
            self.expect_all_stars()
            self.picture(f"step-{number}")
            self.press("Next" if number < len(steps) else "Finish")

    def take_step(self, number, step):
        if step.quiz:
            self.answer(step.quiz)
        if step.puzzle:
            order, *_ = right_orders(self.opened, step.puzzle)
            self.put_in_order(order)
            self.picture(f"puzzle-{number}")
            self.press("Check")
        if step.check:
            if step.phase != "run":
                self.write(self.opened.solution(number))
            self.run()
        if step.variants:
            self.press("Check everywhere")
            expect(self.panel()).to_contain_text("works everywhere", timeout=LONGEST_RUN)

    def expect_all_stars(self):
        stars = self.panel().locator(".lesson-stars").first
        expect(stars).to_have_attribute("aria-label", re.compile(r"^(\d+) of \1 star"))

    def expect_finished(self, stars):
        """Wait for the start page, where the lesson's card has all stars."""
        card = self.page.locator(".lesson-card", has_text=self.title)
        expect(card).to_contain_text(f"{stars}/{stars}")

    def picture(self, name):
        self.pupil.picture(name)

    def panel(self):
        return self.page.locator("[data-region=lesson]")

    def button(self, name):
        return self.panel().get_by_role("button", name=name, exact=True)

    # What the mouse does.

    def open(self):
        level = self.opened.lesson.level
        self.page.get_by_role("button", name=re.compile(f"^{level} · ")).click()
        self.page.locator(".lesson-card").get_by_role("button", name=self.title).first.click()
        self.pupil.expect_project(self.title)
        self.pupil.choose("Speed", "Fastest")

    def press(self, name):
        self.button(name).click()

    def answer(self, quiz):
        answers = [words(choice.text) for choice in quiz.choices]
        [right] = (text for text, choice in zip(answers, quiz.choices, strict=True) if choice.right)
        self.choose(answers, right)
        self.press("Check")

    def choose(self, answers, right):
        del answers
        self.panel().get_by_role("radio", name=right, exact=True).check()

    def put_in_order(self, order):
        for piece in order:
            self.add(self.panel().get_by_role("button", name=f"Add {piece}", exact=True).first)

    def add(self, piece):
        piece.click()

    def write(self, program):
        self.pupil.show("Block-Text")
        self.pupil.write("blocktext", program)
        self.pupil.wait_until_saved()

    def run(self):
        self.pupil.run_to_the_end()


class TypingPlayer(Player):
    """Uses nothing but the keyboard."""

    def __init__(self, pupil, name):
        super().__init__(pupil, name)
        self.keys = Typist(pupil)

    def open(self):
        level = self.opened.lesson.level
        self.keys.walk("Tab", f"^{level} · ")
        self.keys.press("Enter")
        self.keys.walk("Tab", re.escape(self.title))
        self.keys.press("Enter")
        self.pupil.expect_project(self.title)
        expect(self.panel()).to_contain_text("Step 1")
        self.keys.speed(len(SPEEDS))

    def press(self, name):
        self.to_the_lesson()
        self.keys.walk("Tab", f"^{name}$")
        self.keys.press("Enter")

    def choose(self, answers, right):
        self.to_the_lesson()
        # Tab leads to the first answer, and the arrows go through the others.
        self.keys.walk("Tab", f"^{re.escape(answers[0])}$")
        self.keys.walk("ArrowDown", f"^{re.escape(right)}$")
        self.keys.press("Space")

    def add(self, piece):
        self.to_the_lesson()
        name = piece.evaluate("one => one.textContent.trim()")
        self.keys.walk("Tab", f"^{re.escape(name)}$")
        self.keys.press("Enter")

    def to_the_lesson(self):
        self.keys.go_to("lesson")

    def write(self, program):
        if not self.pupil.editor("blocktext").is_visible():
            self.keys.switch("Block-Text")
        self.keys.go_to("blocktext")
        self.keys.press("Control+a")
        self.page.keyboard.insert_text(program)
        self.pupil.wait_until_saved()

    def run(self):
        self.keys.press("Control+Enter")
        expect(self.panel().locator(".lesson-goal.open")).to_have_count(0, timeout=LONGEST_RUN)


class TouchingPlayer(Player):
    """Uses a finger, on a phone, where the lesson is a sheet."""

    def open(self):
        level = self.opened.lesson.level
        self.page.get_by_role("button", name=re.compile(f"^{level} · ")).tap()
        self.page.locator(".lesson-card").get_by_role("button", name=self.title).first.tap()
        self.unfold()

    def unfold(self):
        if not self.pupil.dialog().count():
            self.page.locator(".lesson-open").tap()
        expect(self.pupil.dialog()).to_be_visible()

    def fold(self):
        self.pupil.dialog().get_by_role("button", name="Close").tap()
        expect(self.pupil.dialog()).to_have_count(0)

    def panel(self):
        return self.pupil.dialog()

    def press(self, name):
        self.button(name).tap()

    def choose(self, answers, right):
        del answers
        self.panel().get_by_text(right, exact=True).tap()

    def add(self, piece):
        piece.tap()

    def write(self, program):
        self.fold()
        self.page.locator(".areas").get_by_role("button", name="Block-Text").tap()
        self.pupil.write("blocktext", program)
        self.pupil.wait_until_saved()
        self.unfold()

    def run(self):
        self.fold()
        self.page.locator("#run").get_by_role("button", name="Run").tap()
        state = self.page.locator(".status .state").first
        expect(state).to_contain_text("Running")
        expect(state).to_contain_text("Ended", timeout=LONGEST_RUN)
        self.picture("ended")
        self.unfold()


def words(text):
    """A text of a lesson in English."""
    return text if isinstance(text, str) else text["en"]


def test_a_lesson_of_level_3_is_played_by_mouse(own_server, sit_down):
    player = Player(sit_down(own_server, start=True, flat=True), "3-04-lists-tour")
    player.play()
    player.expect_finished(stars=5)


def test_a_lesson_of_level_2_is_played_by_keyboard(own_server, sit_down):
    player = TypingPlayer(sit_down(own_server, start=True, flat=True), "2-05-counting")
    player.play()
    player.expect_finished(stars=5)


def test_a_lesson_of_level_1_is_played_by_touch_on_a_phone(own_server, sit_down):
    pupil = sit_down(own_server, start=True, viewport=PHONE, has_touch=True, flat=True)
    player = TouchingPlayer(pupil, "1-03-square")
    player.play()
    player.expect_finished(stars=5)


def test_a_lesson_is_read_in_spanish(own_server, sit_down):
    pupil = sit_down(own_server, start=True, language="es", flat=True)
    opened = find_lesson("2-02-follow-a-line")
    pupil.page.get_by_role("button", name=re.compile("^2 · ")).click()
    pupil.page.locator(".lesson-card").get_by_role("button", name="Sigue la línea").first.click()
    lesson = pupil.page.locator("[data-region=lesson]")
    expect(lesson).to_contain_text("¿Qué hace el robot?")
    pupil.picture("step-1")
    lesson.get_by_role("button", name="Siguiente").click()
    expect(lesson).to_contain_text("Paso 2 de 5")
    expect(pupil.page.locator("[data-region=world]")).to_contain_text("una vuelta")
    expect(pupil.menu("Mundo")).to_contain_text("Una pista cerrada")
    lesson.get_by_role("button", name="Siguiente").click()
    expect(lesson).to_contain_text("Paso 3 de 5")
    pieces = lesson.locator(".lesson-piece")
    expect(pieces).to_have_count(len(right_orders(opened, opened.step(3).puzzle)[0]) + 1)
    expect(pieces.get_by_text("si no", exact=True)).to_have_count(2)
    pupil.picture("step-3")
