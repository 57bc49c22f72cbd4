# Why a name can't be changed, or functions can't become a library.

## A new name

edit-bad-name = '{ $name }' can't be a name. Use letters, digits and _, and don't begin with a digit.
edit-variable-exists = There is already a variable '{ $name }'. Choose another name.
edit-function-exists = There is already a function '{ $name }'. Choose another name.
edit-when-exists = There is already a 'when { $name }'. Choose another name.
edit-name-of-state = The name '{ $name }' belongs to 'when { $when }'. Choose another name.
edit-language-function = '{ $name }' is a function of the language. Choose another name.
edit-when-start = 'when start' can't be renamed, because only this name runs at the start.
edit-used-in-line = The Python code on line { $line } uses '{ $name }'. Change it there by hand.
edit-used-in-python = The Python code of the program uses '{ $name }'. Change it there by hand.

## Functions for a library. $function: the function that needs something else

edit-event-in-library = '{ $function }' uses the event '{ $name }', and a library can't have a 'when'. Pass the value as an argument.
edit-call-in-library = '{ $function }' calls '{ $name }', which is not a function of this program. A library must contain all functions that it calls.
edit-function-without-call = '{ $function }' uses the function '{ $name }' without calling it in Block-Text. Call it in Block-Text, so that it gets the robot.
edit-set-in-python = The Python code in '{ $function }' uses '{ $name }', which other Python code of the program sets. Set or import it inside the function.
edit-shared-variable = The functions use '{ $name }', which line { $line } also sets. Pass it as an argument, since a library has its own variables.
edit-variable-from-robot = '{ $name }' gets its first value from the robot or a function, which a library does not have yet. Pass it as an argument.

## The program has errors

# $task: rename, import (a library) or format
edit-errors-first = Fix the errors in the program first. { $task ->
    [import] Then import the library.
    [rename] Then change the name.
   *[format] Then format the program.
}
