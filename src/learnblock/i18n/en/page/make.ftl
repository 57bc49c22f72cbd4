# Making the blocks of a program.

page-make-button = Make a block
page-make-none = Name blocks that you use often.
page-make-here = In this project
page-make-change = Change this block…
page-make-title-change = Change a block
page-make-used = You use it like this
page-make-defined = You say what it does here
page-make-name = Name
page-make-placeholder = my_block
# $name is what was typed, or the name that results from it.
page-make-unnamed = Give it a name, such as “dance” or “go home”.
page-make-reserved = “{ $name }” is a word of the language. Choose another name.
page-make-taken = There is already something called “{ $name }”. Choose another name.
page-make-in-texts = It is called “{ $name }” in the program, because names have no spaces or signs.
page-make-inputs = Inputs
page-make-input-name = Name of input { $number }
page-make-kind = Kind of { $name }
page-make-kind-number = Number
page-make-kind-text = Text
page-make-kind-truth = Yes or no
# The names of new inputs: letters, digits and _ only.
page-make-name-number = number
page-make-name-text = text
page-make-name-truth = choice
page-make-first-text = hello
page-make-sample = First value of { $name }
page-make-no-number = Enter a number.
page-make-yes = yes
page-make-no = no
page-make-up = Move { $name } up
page-make-delete = Delete { $name }
page-make-it = Make it
page-make-change-it = Change it
