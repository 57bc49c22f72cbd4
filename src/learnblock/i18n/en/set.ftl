# Block sets: their names and files.

set-bad-name = A block set cannot be named '{ $name }'. Use at most 60 letters, digits, spaces, - and _.
set-built-in-name = '{ $name }' is the name of a built-in block set. Choose another name.
set-name-taken = You already have a block set '{ $name }'. Choose another name, or save again to replace it.
# $reason is the operating system's.
set-unreadable = The block set cannot be read: { $reason }
