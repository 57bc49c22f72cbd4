# Errors in Python: in a Python program, or in a part of a program that is Python.

python-too-deep = This Python is nested too deeply. Store part of it in a variable.
# Any other error. $reason: the message of Python, in English
python-syntax = This is not valid Python: { $reason }.
python-invalid-syntax = Python does not understand this. Check for typos and for missing symbols.
python-missing-comma = Python does not understand this. Is a comma missing?
python-comparison = Write '==' to compare. '=' sets a variable.
python-expected = Write '{ $symbol }' here.
python-missing-block = Put { $spaces } spaces at the beginning of this line. It belongs to '{ $header }' above.
python-no-block = There is nothing inside '{ $header }'. Write a line below it, with { $spaces } spaces at the beginning.
python-unexpected-indent = Remove the spaces at the beginning of this line. It is indented too far.
python-uneven-indent = Indent this line exactly like one of the lines above.
python-tabs-and-spaces = Indent with spaces only. The lines here mix tabs and spaces.
python-never-closed = This '{ $symbol }' is never closed. Write '{ $closing }' where it ends.
python-never-closed-in-line = This '{ $symbol }' is never closed. Write '{ $closing }' where it ends: '{ $instead }'.
python-brackets-never-closed = { $count } brackets are not closed here. Write '{ $closing }' at the end: '{ $instead }'.
python-never-closed-below = This '{ $symbol }' is never closed. Write '{ $closing }' at the end of line { $last }, after '{ $after }'.
python-unmatched = This '{ $symbol }' closes nothing. Remove it, or write the opening bracket.
python-wrong-bracket = This '{ $closing }' does not match the opening '{ $opening }'.
python-missing-quote = This text has no closing quote. Write one where the text ends.
python-unexpected-end = The program ends too early. Check for a missing bracket or line.
python-bad-number = This is neither a number nor a name. Begin names with a letter.
python-bad-character = The character { $character } is not allowed here. Remove it, or write a plain one.
python-bad-target = Write the name of a variable before '='.
python-after-backslash = Nothing can follow '\' on its line. Remove it.
python-call-without-brackets = Write the arguments of '{ $function }' in brackets: '{ $function }(...)'.

## Lines of other languages

python-block-text = '{ $found }' is Block-Text, not Python. Give the file a name that ends in '.bt', or write only what is inside the block.
python-main = '{ $found }' is Block-Text. In Python there is no '{ $found }': remove it, and the spaces before the lines below it.
python-when = '{ $found }' is Block-Text. In Python write '{ $decorator }', below it 'def { $name }():', and 'robot.run()' as the last line.
python-count = Write '{ $found } += 1' to count.
python-brace = Remove '{ $found }'. In Python a block ends where its indentation ends.

## Names that do not exist

# $module: such as sim_ebo
python-no-robot = The program has no robot. Write 'from learnblock.robots.{ $module } import Robot' and 'robot = Robot()' at the top.
python-robot-import = 'Robot' can't be imported from there. Write 'from learnblock.robots.{ $module } import Robot'.
python-robot-not-created = The robot is not created yet. Write 'robot = Robot()'.
python-robot-lower-case = Write 'Robot()' with a capital 'R': 'robot = Robot()'.
python-robot-class = Write 'robot.{ $skill }(...)', with a small 'r'.
python-function = In Python a skill belongs to the robot. Write 'robot.{ $skill }(...)' instead of 'function.{ $skill }(...)'.
python-end = Python has no 'end'. Remove it: a block ends where its indentation ends.
python-not-imported = The module '{ $module }' is not imported. Write 'import { $module }' at the top.
# $module: such as learnblock.devices; $name: such as Base
python-not-imported-from = '{ $name }' is not imported. Write 'from { $module } import { $name }' at the top.
python-skill-without-brackets = A skill needs its brackets. Write 'robot.{ $skill }()'.
python-unknown-when = There is no event '{ $name }'. Write '@robot.when' and, below it, 'def { $name }():' above this line, or check the name.

## Events

# $found: such as @robot.whem
python-unknown-event = There is no '{ $found }'. Write '@robot.when' for an event, or '@robot.when_start' for what runs once at the start.
python-unknown-event-near = There is no '{ $found }'. Did you mean '@robot.{ $near }'?
python-event-of-robot = An event belongs to the robot. Write '@robot.{ $name }' instead of '{ $found }'.
python-event-without-at = An event begins with '@'. Write '@robot.{ $name }'.
python-wait-without-lambda = Waiting has to ask its condition again and again. Write 'robot.wait_until(lambda: { $condition })'.
python-event-without-lambda = An event has to ask its condition again and again. Write '@robot.when(lambda: { $condition })'.
python-never-run = The events never run, because 'robot.run()' is missing. Write it as the last line.
