# Problems of blocks, shown at the block.

workspace-missing-value = This block is missing a value. Plug one in.
workspace-missing-condition = This block has no condition, which counts as false. Plug one in.
workspace-missing-variable = This block is missing a variable. Choose one.
workspace-missing-python = Write a Python expression here.
workspace-bad-number = This is not a number. Write one, such as 40.
# $field: the name of the field
workspace-unknown-choice = This block has an unknown option in '{ $field }'. Choose another.
# $nearest: a name that is allowed
workspace-bad-name = '{ $name }' can't be a name here. Use letters, digits and _, as in '{ $nearest }', but not a reserved word.
workspace-duplicate-argument = The argument '{ $name }' is given twice. Rename or remove one.
workspace-duplicate-parameter = Two parameters of this function have the same name. Rename one.
workspace-unknown-skill = There is no skill '{ $name }' here. Remove this block.
# $type: the name of the type in Blockly
workspace-unknown-block = A program can't have a block of type '{ $type }' here. Remove it.
workspace-misplaced-block = This block belongs under 'at the start', outside of all other blocks.
workspace-robot-not-first = 'robot' must come before everything else. Move this block to the beginning.
workspace-second-main = A program can only have one main block. Move the blocks under this one to the other one.
workspace-empty-comparison = This comparison compares nothing. Remove it.
workspace-python-lines = A Python value must be on one line. Use the block for Python lines instead.
workspace-unused-value = This value is not used. Store it in a variable, or remove it.
workspace-list-without-name = Only a list in a variable can be changed. Choose one.
workspace-import-name = Write only the name of the library, such as 'dance', without a folder or '.py'.
workspace-too-many-values = Too many values are nested here. Store some of them in a variable.
workspace-too-deep = Too many blocks are nested here. Move some of them into a function.
