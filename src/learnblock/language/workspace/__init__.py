"""Read and write workspaces of Blockly.

`conversion.py` is the way in. Statements are written in `statement_shapes.py`,
values in `shapes.py`; reading is split by the kind of block:

==========================================  ============================  ===================
blocks                                      node                          read in
==========================================  ============================  ===================
``lb_main``, ``lb_when``, ``procedures_*``  Main, When, Def               reader.py
``lb_when_*``, ready hats                   When, SkillCall               reader.py
``lb_import``, ``lb_setup``                 Import, Setup                 reader.py
``controls_*``, ``lb_wait_until``           If, While, Repeat, WaitUntil  statement_reader.py
``variables_set``, ``math_change``          Assign                        statement_reader.py
skills and calls on their own               Perform                       statement_reader.py
changes of lists and dictionaries           Assign, Perform               container_reader.py
``lb_python``, ``lb_comment``               Raw, Comment                  statement_reader.py
``lb_python_line``, ``lb_python_block``     PythonLine, PythonBlock       statement_reader.py
``math_*``, ``logic_*``, ``text_*``         Binary, Compare, FString      value_reader.py
numbers, texts, True and False              Number, String, Constant      literals.py
skills and calls that answer                SkillCall, Call               value_reader.py
the inputs of a skill                       Keyword                       arguments.py
==========================================  ============================  ===================

`python_shapes.py` makes sockets for the values in Python that stays Python. `types.py` has the
types and inputs of all these blocks, `blocks.py` their form in messages and files, `notes.py` what
a block stores but doesn't show. `writer.py` and `value_writer.py` turn shapes into blocks and keep
those of the workspace before, which `alignment.py` finds and `survey.py` lists; `arrangement.py`
decides which stack is where. `block_reader.py` is below all readers. Messages: `idle_blocks.py`
about blocks that do nothing, `wording.py` in the words of blocks. `own_variables.py` makes
variables local in the functions that the page makes.
"""
