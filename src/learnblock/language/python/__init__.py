"""Read and write Python, with ast and tokenize of the standard library.

`writer.py` writes every node. Reading is split by what a node of ast becomes:

==========================================  ==============================  ======================
Python                                      node                            read in
==========================================  ==============================  ======================
the parts that create and run the robot     Setup                           skeleton.py
the import of the robot                     Setup                           robot_import.py
``from learnblock.libraries... import *``   Import                          definition_reader.py
``def``, ``@robot.when``                    Def, When                       definition_reader.py
the rest of the file                        Main                            reader.py
comments, blank lines, marked raw Python    Comment, Blank, Raw             comment_reader.py
``if``, ``while``, ``for``                  If, While, Repeat, ForEach      statement_reader.py
``for i in range(...)``                     ForRange                        statement_reader.py
``x = 1``, ``x += 1``, ``del x[1]``         Assign, Perform                 statement_reader.py
``robot.wait_until(...)``, ``return``       WaitUntil, Return               statement_reader.py
``turn.activate()``, ``turn.deactivate()``  Activate, Deactivate            statement_reader.py
``break``, ``continue``, ``pass``           Break, Continue, Pass           statement_reader.py
operators, constants, names, f-strings      Binary, Compare, Name, FString  expression_reader.py
``robot.get_tag()``, ``sqrt(x)``            SkillCall, Call                 expression_reader.py
lists, dictionaries, ``a if b else c``      List, Dictionary, Conditional   expression_reader.py
any other statement                         PythonLine, PythonBlock         python_reader.py
any other expression, several in a line     RawExpression, Raw              the reader of its kind
==========================================  ==============================  ======================

`imports.py` names a library's module. `forms.py` splits a line that stays Python into words and
values, for blocks; `quotes.py` keeps its f-strings readable by every version. `scopes.py` decides
whether the local variables of functions could be shared. `generation.py` puts a whole program
together, with a map of its lines (`source_map.py`), or the functions of a library. `parsing.py`
parses a file; `syntax_errors.py` and `foreign_lines.py` explain what is no Python.
"""
