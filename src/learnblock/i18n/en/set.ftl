# Block sets: their names and files.

set-bad-name = A block set cannot be named '{ $name }'. Use at most 60 letters, digits, spaces, - and _.
set-built-in-name = '{ $name }' is the name of a built-in block set. Choose another name.
set-name-taken = You already have a block set '{ $name }'. Choose another name, or save again to replace it.
# $reason is the operating system's.
set-unreadable = The block set cannot be read: { $reason }

# The built-in sets.
set-first-steps-title = First steps
set-first-steps-about = One step after the other: drive, turn, wait, show a feeling.
set-loops-and-functions-title = Loops and functions
set-loops-and-functions-about = Write it once, run it often: repeat, count, and give part of the program a name.
set-senses-title = Senses and decisions
set-senses-about = The robot senses and decides: if, while, obstacles, lines, tags, faces.
set-events-title = Events
set-events-about = Several things at once: an event for everything that can happen, and states to switch between.
set-everything-title = Everything
set-everything-about = All blocks, including custom blocks and libraries.
