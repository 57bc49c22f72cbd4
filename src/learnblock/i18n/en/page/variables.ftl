# The table of variables and events.

page-variables-title = Program variables
page-variables-name = Name
page-variables-value = Value
page-variables-stack = In { $functions }
page-variables-local = In this function
page-variables-shared = Global
page-variables-open = Show the parts of { $name }
page-variables-whens = Event
page-variables-state = State
page-variables-time = Active for
page-variables-active = ● active
page-variables-inactive = ○ waiting
page-variables-nothing = Run a program to see its variables.
page-variables-changes = Changes
page-variables-change-before = Go to the previous change of { $name }
page-variables-change-after = Go to the next change of { $name }
