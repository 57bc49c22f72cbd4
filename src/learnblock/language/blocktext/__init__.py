"""Read and write Block-Text: a hand-written lexer and a recursive-descent parser with recovery.

`format.py` writes every node; `parser.py` reads a program, with one file for each level below it:

========================================  =================================  ====================
syntax                                    node                               read in
========================================  =================================  ====================
``import``, ``def``, ``when``, ``main``   Import, Def, When, Main            parser.py
``robot(world="line")``                   Setup                              parser.py
comments, blank lines, headers, ``end``   Comment, Blank                     block_parser.py
``if``, ``elif``, ``else``                If, Branch, Else                   statement_parser.py
``while``, ``forever``, ``repeat``        While, Repeat                      statement_parser.py
``for each``, ``for i from 1 to 10``      ForEach, ForRange                  statement_parser.py
``x = 1``, ``x += 1``, a call on its own  Assign, Perform                    statement_parser.py
``wait until``, ``return``, ``activate``  WaitUntil, Return, Activate        statement_parser.py
``break``, ``continue``, ``pass``         Break, Continue, Pass              statement_parser.py
``python`` up to ``end``                  Raw                                statement_parser.py
``1 + x``, ``not x``, ``1 < x <= 9``      Binary, Unary, Compare             expression_parser.py
numbers, texts, names, lists, items       Number, String, Name, List, Index  expression_parser.py
``function.get_tag()``, ``sqrt(x)``       SkillCall, Call                    expression_parser.py
``{"Ana": 1}``                            Dictionary                         dictionary_parser.py
``f"score: {score}"``                     FString                            f_string_parser.py
========================================  =================================  ====================

What can't be read is explained by `slips.py` and `open_brackets.py` (a word or a bracket) or by
`foreign_lines.py`, `python_lines.py`, `declarations.py`, `spoken_lines.py` and `several_targets.py`
(a whole line), whose rules `line_rules.py` and `line_rewriter.py` apply; `other_names.py` has the
names of other tools, `foreign_words.py` the words of other languages.
`lexer.py` and `token_reader.py` are below all parsers, `nested_reader.py` below those of values.
`order.py` puts definitions above their uses; `names.py` translates names to Python.
"""
