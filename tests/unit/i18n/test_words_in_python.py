"""A language needs no Python: its words are in files."""

import ast
import re
import tomllib
from functools import cache

import pytest

from learnblock.i18n import ENGLISH, languages
from learnblock.language.blocktext.foreign_words import FOLDER
from modules import modules, tree_of

CODES = {
    code for language in languages() if language != ENGLISH for code in (language, language.upper())
}
#: Letters and signs that English lacks.
FOREIGN = re.compile(r"[áéíóúüñÁÉÍÓÚÜÑ¿¡]")
#: What names a language's code or writes its letters, with the reason.
EXCEPTIONS = {
    "learnblock.robots.plain_letters": "what displays show in place of letters that they lack",
    "learnblock.why.mentions": "the end of an English plural",
    "learnblock.why.vocabulary": "the signs around a question are left out, in any language",
}
#: The rules for lines that pupils bring.
RULES = (
    "learnblock.language.blocktext.foreign_lines",
    "learnblock.language.blocktext.other_names",
    "learnblock.language.blocktext.spoken_lines",
    "learnblock.language.python.foreign_lines",
)
#: What may begin with a docstring.
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
#: Words of another language that are English, too, or parts of a pattern.
ENGLISH_TOO = {"decimal"}


@cache
def texts(source):
    """The texts of a module without its docstrings."""
    constants, docstrings = [], set()
    for node in ast.walk(tree_of(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            constants.append(node)
        elif isinstance(node, DOCUMENTED) and node.body and isinstance(node.body[0], ast.Expr):
            docstrings.add(node.body[0].value)
    return [constant.value for constant in constants if constant not in docstrings]


def words_of(language):
    """The words that pupils type in a language, of at least four letters."""
    tables = tomllib.loads((FOLDER / f"{language}.toml").read_text("utf-8"))
    forms = [form for table in tables.values() for words in table.values() for form in words]
    return {word for form in forms for word in form.split() if len(word) > 3} - ENGLISH_TOO


def test_no_module_branches_on_a_language():
    naming = {name for name, source in modules().items() if CODES & set(texts(source))}
    assert naming - EXCEPTIONS.keys() == set()


def test_no_module_has_words_in_another_language():
    writing = {name for name, source in modules().items() if FOREIGN.search("".join(texts(source)))}
    assert writing - EXCEPTIONS.keys() == set()


def test_the_exceptions_are_needed():
    all_texts = {name: texts(modules()[name]) for name in EXCEPTIONS}
    unneeded = [
        name
        for name, found in all_texts.items()
        if not CODES & set(found) and not FOREIGN.search("".join(found))
    ]
    assert unneeded == []


@pytest.mark.parametrize("language", [language for language in languages() if language != ENGLISH])
@pytest.mark.parametrize("module", RULES)
def test_no_rule_for_a_slip_has_words_in_another_language(module, language):
    found = {word for text in texts(modules()[module]) for word in re.findall(r"[^\W\d_]+", text)}
    assert found & words_of(language) == set()
