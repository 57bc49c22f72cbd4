"""The times in questions."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.why.spans import RunSpan, take_span


@pytest.mark.parametrize(
    ("text", "span", "rest"),
    [
        ("why did it turn between 3 and 5 s", RunSpan(5.0, 3.0), "why did it turn"),
        ("why did it turn from 3 to 5 seconds", RunSpan(5.0, 3.0), "why did it turn"),
        ("why did it turn from second 3 to second 5", RunSpan(5.0, 3.0), "why did it turn"),
        ("why did it turn between 5 and 3", RunSpan(5.0, 3.0), "why did it turn"),
        ("between 3 s and 5.5 s why did it turn", RunSpan(5.5, 3.0), "why did it turn"),
        ("por que giro entre 3 y 5", RunSpan(5.0, 3.0), "por que giro"),
        ("por que giro entre los segundos 3 y 5,5", RunSpan(5.5, 3.0), "por que giro"),
        ("por que giro entre el segundo 3 y el segundo 5", RunSpan(5.0, 3.0), "por que giro"),
        ("por que giro del segundo 3 al 5", RunSpan(5.0, 3.0), "por que giro"),
        ("turn 3-5 s", RunSpan(5.0, 3.0), "turn"),
        ("why doesnt it stop after 5 seconds", RunSpan(None, 5.0), "why doesnt it stop"),
        ("por que no para despues de 5 segundos", RunSpan(None, 5.0), "por que no para"),
        ("why did it turn in the first 4 seconds", RunSpan(4.0, 0.0), "why did it turn"),
        ("por que giro antes del segundo 4", RunSpan(4.0, 0.0), "por que giro"),
        ("turn left at 8.9", RunSpan(8.9), "turn left"),
        ("por que giro en el segundo 8,9", RunSpan(8.9), "por que giro"),
        ("por que giro a los 3 segundos", RunSpan(3.0), "por que giro"),
        ("at 5 s why did it turn", RunSpan(5.0), "why did it turn"),
        ("why is x 2", RunSpan(), "why is x 2"),
        ("line 8", RunSpan(), "line 8"),
        (
            "why did it say 5 visited at the first house",
            RunSpan(),
            "why did it say 5 visited at the first house",
        ),
    ],
)
def test_times_are_taken_from_a_question(text, span, rest):
    assert take_span(text) == (span, rest)


@given(st.text(max_size=60))
def test_any_text_keeps_its_other_words(text):
    span, rest = take_span(text)
    assert rest == text or span != RunSpan()
