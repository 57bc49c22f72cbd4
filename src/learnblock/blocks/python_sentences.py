"""The forms of Python that have a sentence on their blocks; the others show Python's words.

A form is Python with ``%1``, ``%2`` for its parts, each a socket, words, or both. The page shows
the sentence of the first form that fits; the sentence is ``LB_PYTHON_`` and the name of the form
in the translations, with the same parts in any order.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

LINE, BLOCK, VALUE = "lb_python_line", "lb_python_block", "lb_python_form"


class PythonForm(NamedTuple):
    """A form of Python.

    Args:
        name: the name of its sentence.
        python: the line, or the first line of a part of a block without its colon.
        of: the words that may begin the block of which it is a further part; empty for any.
    """

    name: str
    python: str
    of: tuple[str, ...] = ()

    @property
    def word(self) -> str:
        """The key of its sentence in the translations."""
        return f"LB_PYTHON_{self.name}"


#: The forms by the type of their blocks; one that is a case of another comes first.
FORMS: Mapping[str, tuple[PythonForm, ...]] = {
    LINE: (
        PythonForm("IMPORT_AS", "import %1 as %2"),
        PythonForm("IMPORT", "import %1"),
        PythonForm("FROM_ALL", "from %1 import *"),
        PythonForm("FROM_AS", "from %1 import %2 as %3"),
        PythonForm("FROM", "from %1 import %2"),
        PythonForm("RAISE_FROM", "raise %1 from %2"),
        PythonForm("RAISE", "raise %1"),
        PythonForm("RAISE_AGAIN", "raise"),
        PythonForm("ASSERT_SAYING", "assert %1, %2"),
        PythonForm("ASSERT", "assert %1"),
        PythonForm("DELETE", "del %1"),
        PythonForm("GLOBAL", "global %1"),
        PythonForm("NONLOCAL", "nonlocal %1"),
        PythonForm("RETURN", "return %1"),
        PythonForm("CHANGE", "%1 += %2"),
        PythonForm("SET", "%1 = %2"),
    ),
    BLOCK: (
        PythonForm("TRY", "try"),
        PythonForm("EXCEPT_AS", "except %1 as %2"),
        PythonForm("EXCEPT_ONE", "except %1"),
        PythonForm("EXCEPT", "except"),
        PythonForm("UNFAILED", "else", ("try",)),
        PythonForm("UNBROKEN", "else", ("for", "while")),
        PythonForm("FINALLY", "finally"),
        PythonForm("WITH_AS", "with %1 as %2"),
        PythonForm("WITH", "with %1"),
        PythonForm("CLASS_KIND", "class %1(%2)"),
        PythonForm("CLASS", "class %1"),
        PythonForm("DEFINE", "def %1()"),
        PythonForm("DEFINE_WITH", "def %1(%2)"),
        PythonForm("EACH", "for %1 in %2"),
        PythonForm("WHILE", "while %1"),
        PythonForm("MATCH", "match %1"),
        PythonForm("ANY_CASE", "case _"),
        PythonForm("CASE_IF", "case %1 if %2"),
        PythonForm("CASE", "case %1"),
    ),
    VALUE: (
        PythonForm("LIST_IF", "[%1 for %2 in %3 if %4]"),
        PythonForm("LIST_OF", "[%1 for %2 in %3]"),
        PythonForm("DICTIONARY_IF", "{%1: %2 for %3 in %4 if %5}"),
        PythonForm("DICTIONARY_OF", "{%1: %2 for %3 in %4}"),
        PythonForm("SET_IF", "{%1 for %2 in %3 if %4}"),
        PythonForm("SET_OF", "{%1 for %2 in %3}"),
        PythonForm("VALUES_IF", "(%1 for %2 in %3 if %4)"),
        PythonForm("VALUES_OF", "(%1 for %2 in %3)"),
        PythonForm("LAMBDA_ALONE", "lambda: %1"),
        PythonForm("LAMBDA", "lambda %1: %2"),
        PythonForm("CONDITIONAL", "%1 if %2 else %3"),
        PythonForm("SLICE_STEP", "%1[%2:%3:%4]"),
        PythonForm("EVERY", "%1[::%2]"),
        PythonForm("SLICE_FROM", "%1[%2:]"),
        PythonForm("SLICE_TO", "%1[:%2]"),
        PythonForm("SLICE", "%1[%2:%3]"),
    ),
}


def python_forms() -> list[dict[str, Any]]:
    """The forms as the page reads them."""
    return [
        {"type": kind, "python": form.python, "word": form.word, "of": list(form.of)}
        for kind, forms in FORMS.items()
        for form in forms
    ]
