"""Read functions, ``when``s and imports of libraries, which stand at the top of a file."""

import ast

from learnblock.language.blocktext import names
from learnblock.language.blocktext.names import state_of
from learnblock.language.python import imports
from learnblock.language.python.expression_reader import Unlike, end_of, span_of
from learnblock.language.python.python_reader import PythonReader
from learnblock.language.python.scopes import first_of_locals, stored_names
from learnblock.language.python.skeleton import leading_globals, unusual
from learnblock.language.python.statement_reader import acts
from learnblock.language.python.writer import global_names
from learnblock.language.tree.nodes import (
    AnyPython,
    Body,
    Def,
    Expression,
    Import,
    Item,
    Pass,
    When,
)
from learnblock.language.tree.traversal import statements


class DefinitionReader(PythonReader):
    """Reads what is defined at the top of a file, and its other statements."""

    def item(self, node: ast.stmt) -> Item:
        match node:
            case ast.ImportFrom(module=str(), names=[ast.alias(name="*")], level=0):
                return self.import_(node)
            case ast.FunctionDef():
                return self.function(node)
            case _:
                return self.statement(node)

    def import_(self, node: ast.ImportFrom) -> Import:
        module = imports.from_python(node.module or "")
        if module is None or self.is_own_style:
            raise Unlike
        return Import(module, self.comment_after(node), span_of(node))

    def function(self, node: ast.FunctionDef) -> Def | When:
        arguments = node.args
        if node.returns or getattr(node, "type_params", None) or unusual(arguments):
            raise Unlike
        comment = self.header_comment(node.lineno, node.body)
        if node.decorator_list:
            return self.when(node, comment)
        name = names.from_python(node.name)
        parameters = tuple(self.called(argument.arg) for argument in arguments.args)
        if name is None or self.reads_value_of_event(node):
            raise Unlike
        body = self.function_body(node, parameters)
        return Def(name, parameters, body, comment, span_of(node))

    def reads_value_of_event(self, node: ast.FunctionDef) -> bool:
        """Whether a function uses a parameter that Block-Text would take for an event's value."""
        parameters = {argument.arg for argument in node.args.args}
        return any(
            isinstance(inner, ast.Name)
            and inner.id in parameters
            and state_of(names.from_python(inner.id) or "", self.when_names)
            for inner in ast.walk(node)
        )

    def when(self, node: ast.FunctionDef, comment: str | None) -> When:
        name = self.whens.get(node.name)
        if name is None or node.args.args:
            raise Unlike
        condition: Expression | None = None
        match node.decorator_list[0]:
            case ast.Call(args=[ast.Lambda(body=test)]):
                condition = self.expression(test)
            case ast.Attribute(attr="when_start") if name != "start":
                raise Unlike
            case ast.Attribute(attr="when") if name == "start":
                raise Unlike
        body = self.function_body(node, ())
        return When(name, condition, body, comment, span_of(node))

    def function_body(self, node: ast.FunctionDef, parameters: tuple[str, ...]) -> Body:
        self.keeps_globals = False
        self.first_of_locals = first_of_locals(node)
        try:
            body = self.body(node.lineno, node.body, end_of(node) + 1)
        finally:
            self.keeps_globals = True
            self.first_of_locals = frozenset()
        body = self.trailing(body, node)
        if not self.shares_enough(node, body, parameters):
            raise Unlike
        return body if any(map(acts, body)) else (*body, Pass())

    def shares_enough(self, node: ast.FunctionDef, body: Body, parameters: tuple[str, ...]) -> bool:
        """Whether a function has for itself what it had, and shares the rest."""
        statements_of_globals = leading_globals(node.body)
        written = [name for statement in statements_of_globals for name in statement.names]
        declared = set(written)
        names_of_globals = global_names(body, parameters, self.when_names)
        if self.is_own_style:
            # What a person wrote keeps its words, and a local variable stays local.
            every = [inner for inner in ast.walk(node) if isinstance(inner, ast.Global)]
            in_place = every == statements_of_globals and len(every) <= 1
            return in_place and written == names_of_globals
        shared = set(names_of_globals)
        needless = declared - shared
        if needless and any(isinstance(statement, AnyPython) for statement in statements(body)):
            return False
        return shared <= declared and not needless & stored_names(node)
