"""Checks in words, in English and Spanish."""

import pytest

from learnblock.i18n import translate
from learnblock.lessons import checks
from learnblock.lessons.checks import (
    At,
    Called,
    Collided,
    Drives,
    Ends,
    EndsAt,
    Expert,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Printed,
    Prints,
    Reaches,
    Said,
    Sent,
    Shown,
    Size,
    StaysOnLine,
    Stood,
    Turns,
    Uses,
)
from learnblock.lessons.describing import describe, event_words, title_of

WORDS = [
    (Reaches(), "Reach all goals.", "Alcanza todas las metas."),
    (Reaches(goals=("a",)), "Reach the goal 'a'.", "Alcanza la meta 'a'."),
    (
        Reaches(goals=("a", "b"), within=20),
        "Reach the goals a, b within 20 s.",
        "Alcanza las metas a, b en menos de 20 s.",
    ),
    (
        Happens(what=Shown(what="joy")),
        "The robot shows 'joy'.",
        "El robot muestra 'joy'.",
    ),
    (
        Happens(what=Printed(what="hi"), at_least=2),
        "The program prints 'hi' at least twice.",
        "El programa escribe 'hi' al menos dos veces.",
    ),
    (
        Happens(what=Printed(what="hi"), at_least=3, at_most=3),
        "The program prints 'hi' exactly 3 times.",
        "El programa escribe 'hi' exactamente 3 veces.",
    ),
    (
        Happens(what=Printed(what="hi"), at_least=0, at_most=1),
        "The program prints 'hi' at most once.",
        "El programa escribe 'hi' como máximo una vez.",
    ),
    (
        Happens(what=Printed(what="*"), at_most=2, within=5),
        "The program prints a line at least once and at most twice within 5 s.",
        "El programa escribe una línea al menos una vez y como máximo dos veces en menos de 5 s.",
    ),
    (
        Never(what=Collided()),
        "The robot never bumps into anything.",
        "El robot no choca nunca con nada.",
    ),
    (
        InOrder(events=(GoalReached(name="a"), Shown(what="joy")), within=2),
        "These things happen in this order, with at most 2 s between one and the next: "
        "the goal 'a' is reached, the robot shows 'joy'.",
        "Esto ocurre en este orden, con 2 s como máximo entre una cosa y la siguiente: "
        "se alcanza la meta 'a', el robot muestra 'joy'.",
    ),
    (
        StaysOnLine(),
        "Stay on the line 'line' for 90 % of the time.",
        "Quédate sobre la línea 'line' durante el 90 % del tiempo.",
    ),
    (Drives(at_least=500), "Drive at least 500 mm.", "Recorre al menos 500 mm."),
    (Drives(at_most=500), "Drive at most 500 mm.", "Recorre 500 mm como máximo."),
    (
        EndsAt(x=300, y=0),
        "Stop within 50 mm of the place (300, 0).",
        "Párate a menos de 50 mm del lugar (300, 0).",
    ),
    (
        EndsAt(x=300, y=0, heading=90),
        "Stop within 50 mm of the place (300, 0), with the heading 90°.",
        "Párate a menos de 50 mm del lugar (300, 0), con el rumbo 90°.",
    ),
    (Turns(by=-360), "Turn by -360° in all.", "Gira -360° en total."),
    (
        Ends(within=30),
        "The program runs to its end within 30 s.",
        "El programa llega a su final en menos de 30 s.",
    ),
    (
        Prints(lines=("1", "2")),
        "Print these lines in this order: 1, 2.",
        "Escribe estas líneas en este orden: 1, 2.",
    ),
    (
        Expert(function="f"),
        "The lesson's own check 'f'.",
        "La comprobación propia de la lección 'f'.",
    ),
    (Uses(construct="loop"), "Use a loop.", "Usa un bucle."),
    (Uses(skill="turn", at_most=2), "Use the block turn at most twice.",
     "Usa el bloque turn dos veces como máximo."),
    (Uses(construct="if", at_least=0, at_most=0), "Do not use 'if'.", "No uses 'if'."),
    (
        Uses(function="f", at_least=2),
        "Use your function f at least twice.",
        "Usa tu función f al menos dos veces.",
    ),
    (Size(blocks=6), "Use at most 6 blocks.", "Usa 6 bloques como máximo."),
    (Ends(robot="two"), "two: The program runs to its end.",
     "two: El programa llega a su final."),
]  # fmt: skip
EVENTS = [
    (GoalReached(name="a"), "the goal 'a' is reached"),
    (Shown(what="joy"), "the robot shows 'joy'"),
    (Said(what="hi"), "the robot says 'hi'"),
    (Printed(what="hi"), "the program prints 'hi'"),
    (Called(skill="turn"), "the program uses turn"),
    (Sent(message="go"), "the program sends the message 'go'"),
    (Collided(), "the robot bumps into something"),
    (Collided(thing="box"), "the robot bumps into 'box'"),
    (At(x=0, y=100), "the robot comes within 100 mm of the place (0, 100)"),
    (Stood(seconds=2), "the robot stands still for 2 s"),
]


@pytest.mark.parametrize(("check", "english", "spanish"), WORDS)
def test_a_check_is_told_in_each_language(check, english, spanish):
    told = [translate(describe(check), language) for language in ("en", "es")]
    assert told == [english, spanish]


def test_every_kind_of_check_and_event_is_told():
    assert {type(check) for check, *_ in WORDS} == {*checks.Check.__args__}
    assert {type(event) for event, _ in EVENTS} == {*checks.Event.__args__}


@pytest.mark.parametrize(("event", "english"), EVENTS)
def test_an_event_is_told(event, english):
    assert str(event_words(event)) == english


@pytest.mark.parametrize(
    ("event", "form", "english"),
    [
        (Shown(what="joy"), "sentence", "The robot shows 'joy'"),
        (Collided(), "never", "The robot never bumps into anything"),
        (Printed(what="*"), "missing", "The program did not print anything"),
        (Printed(what="report: * obstacles"), "past", "The program printed 'report: … obstacles'"),
    ],
)
def test_an_event_begins_a_sentence(event, form, english):
    assert str(event_words(event, form)) == english


@pytest.mark.parametrize("event", [event for event, _ in EVENTS])
@pytest.mark.parametrize("language", ["en", "es"])
def test_every_event_is_told_in_every_form(event, language):
    forms = ("clause", "sentence", "never", "missing", "past")
    assert len({translate(event_words(event, form), language) for form in forms}) == len(forms)


def test_goals_of_our_worlds_are_told_in_the_readers_words():
    check = Reaches(goals=("the whole tour",))
    assert translate(describe(check), "es") == "Alcanza la meta 'la ruta entera'."


def test_the_words_of_the_lesson_come_first():
    check = Ends(say={"en": "Finish.", "es": "Acaba."})
    assert [title_of(check, one) for one in ("en", "es", "fr")] == ["Finish.", "Acaba.", "Finish."]
