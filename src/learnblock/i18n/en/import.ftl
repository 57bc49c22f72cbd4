# Importing programs of the original LearnBlock.

## The file

import-too-large = The file has { $size } bytes, but a project of the original LearnBlock can have at most { $limit }.
import-too-many = The file has more than { $limit } values. No project of the original LearnBlock has so many.
import-too-deep = The values in this file are nested too deeply for a project of the original LearnBlock.
# $byte is a position in the file.
import-damaged = This file is damaged or not a project of the original LearnBlock: it can't be read at byte { $byte }.
# $what is a technical name, such as os.system.
import-forbidden = This file contains '{ $what }' before byte { $byte }, which no project of the original LearnBlock does. Nothing in it was run; do not open it elsewhere.
# $place is a technical name, such as blocks or turn.vars.
import-wrong-project = This file is not a project of the original LearnBlock: '{ $place }' is missing or has another form.
import-nested = The blocks in this project are nested more than { $limit } deep. Split the program into functions in the original LearnBlock.

## What changed

import-old-name = The skill '{ $name }' is now called '{ $today }'.
import-renamed = The name '{ $name }' became '{ $new }', because names contain letters, digits and '_'.
import-print-brackets = 'print' now has brackets.
import-degrees = In '{ $skill }', { $radians } radians per second became { $degrees } degrees per second.
import-unset = The variable '{ $name }' had no value at the start. It is now 0.
import-twice = There is more than one '{ $name }'. The first one is used; the blocks of the others are loose.
import-heard = A message is now heard by the event 'when { $event } = { $condition }'. Put into it what the message should start.
import-library = The project used the library '{ $name }'. Its functions are now part of the program.

## What is missing

import-unknown-skill = There is no skill '{ $skill }'. As a statement it became a comment; as a condition it became False.
import-unread-line = '{ $text }' can't be read. As a statement it became a comment; as a condition it became False.
import-no-condition = A '{ $name }' had no condition. It became False.
import-no-if = An '{ $name }' had no 'if' above it. It became an 'if'.
import-left-out = The block '{ $name }' is connected in a circle or to two blocks. It was left out.
import-no-library = The library '{ $name }' is not beside the project. Copy its folder there and import the project again.
import-no-function = The function '{ $name }' is not in the project. It is now an empty function: fill it in.
import-no-event = The event '{ $name }' is not in the project. It is now an empty event: fill it in.
import-argument-dropped = '{ $skill }' no longer takes the value { $value }.
import-argument-missing = '{ $skill }' had no value for '{ $name }' that can be read. It is now { $value }.
import-python-only = '{ $name }' has functions in Python that use the robot of the original LearnBlock: { $functions }. Write them again as custom blocks.
import-no-block = The file describes a block '{ $name }', but has no function for it.

import-not-readable = '{ $name }' can't be read and was left out: { $reason }
import-not-only-functions = The library contains more than functions. It was imported as a program instead.
import-not-a-library = The functions can't be made into a library: { $reason } They were imported as a program instead.

## Files and folders

# $name is the name of a file.
import-only-program = '{ $name }' can't become a library, because its functions can only be used in a program. Open this file alone to use it as a program.
import-type = LearnBlock can't import this type of file. Choose a .blockProject or .lb file, or a folder with such files.
import-nothing = There is nothing to import in { $folder }: it has no .blockProject or .lb files.
import-no-functions = This file has no functions.
import-exists = { $file } exists. Use --replace to replace it, or --output to write to another folder.
import-imported = { $file }: imported as { $target }
import-changed = changed:
import-missing = not carried over:
