# Lessons: their cards on the start page, and the panel beside the program.

## The cards

page-lesson-cards-title = Lessons
page-lesson-cards-levels = Level
page-lesson-cards-level-1 = 1 · First drive
page-lesson-cards-level-2 = 2 · Sense and decide
page-lesson-cards-level-3 = 3 · Functions and states
page-lesson-cards-level-4 = 4 · See and cooperate
page-lesson-minutes = { $minutes } min
# What a screen reader says of a card's stars.
page-lesson-stars-of = { $earned } of { $stars } stars
page-lesson-stars-short = { $earned }/{ $stars }
page-lesson-go-on = Step { $step } of { $count }
page-lesson-add = Add a lesson
page-lesson-add-file = From a file…
page-lesson-add-folder = From a folder…
page-lesson-no-folder = This folder has no lesson.toml, so it is not a lesson. Choose the folder that lesson.toml is in.
page-lesson-own = My lesson
page-lesson-delete = Delete { $title }
page-lesson-more = More for { $title }
page-lesson-delete-menu = Delete…
page-lesson-delete-help = The file of the lesson is deleted. Projects that were begun with it stay, without the lesson.
page-lesson-delete-now = Delete lesson
page-lesson-notes = Notes and solutions
page-lesson-copy = Copy and change…
# $title is the title of a lesson.
page-lesson-notes-title = { $title }: notes and solutions
page-lesson-notes-none = This lesson has no notes and no solutions.
page-lesson-notes-solution = Solution
page-lesson-notes-no-solution = This step has no program to solve.
page-lesson-notes-wrong = Typical wrong programs
# $check is what the program fails, as pupils read it.
page-lesson-notes-fails = Fails: { $check }
page-lesson-notes-hint = The hint for it:
page-lesson-worksheet = Save worksheet
page-lesson-worksheet-help = A page to print: tasks, blocks to cut out, lines to write on, and the solutions apart
page-lesson-cards-next = Start here
page-lesson-cards-none = There is no lesson of this level yet.
page-lesson-again = Start { $title } again
# $title is the title of a lesson.
page-lesson-imported = “{ $title }” is in your lessons now.
page-lesson-too-large = { $name } is too large for a lesson.

## The panel

page-lesson-text = Instructions and goals
page-lesson-level = Level { $level }
page-lesson-step-of = Step { $step } of { $count }
page-lesson-phase-predict = Predict
page-lesson-phase-run = Run
page-lesson-phase-investigate = Investigate
page-lesson-phase-modify = Change
page-lesson-phase-make = Make
page-lesson-stars = { $stars ->
    [one] { $earned } of 1 star in this step
   *[other] { $earned } of { $stars } stars in this step
}
page-lesson-fold = Show or hide the instructions
# Instead of a drawing of the program, which is open anyway.
page-lesson-program-there = The program is in your editor.
page-lesson-previous = Previous step
page-lesson-next = Next
page-lesson-finish = Finish
page-lesson-restart = Start this step again
page-lesson-goals = Goals
# Looks at the place in the world where a goal was missed.
page-lesson-show = Show
page-lesson-optional = (bonus)
page-lesson-goal-open = not reached yet
page-lesson-goal-met = reached
page-lesson-goal-failed = not reached
# $goals are the goals that were just reached.
page-lesson-met-said = Reached: { $goals }
page-lesson-star-said = You have earned a star!

## Hints

page-lesson-hint = A hint?
page-lesson-hint-offer = Not yet! Look at the goals, or ask for a hint.
page-lesson-hints-taken = { $count ->
    [one] 1 hint in this step.
   *[other] { $count } hints in this step.
}
page-lesson-hints-more = Press the button again to read more.
page-lesson-hints-all = That was the last hint. Change something and run the program again.

## Questions and puzzles

page-lesson-answer = Check
page-lesson-right = Right!
page-lesson-wrong = Not quite. Try again.
page-lesson-puzzle = Put the pieces in order
page-lesson-puzzle-help = Choose a piece to add it to the program. Not all pieces belong to it.
page-lesson-pieces = Pieces
page-lesson-order = Your program
page-lesson-piece-else = else
page-lesson-piece-add = Add
page-lesson-piece-up = Move up
page-lesson-piece-down = Move down
page-lesson-piece-remove = Put back
page-lesson-puzzle-good = { $count ->
    [0] The first piece is another one.
    [one] The first piece is right.
   *[other] The first { $count } pieces are right.
}

## All variants and robots

page-lesson-everywhere = Check everywhere
page-lesson-everywhere-help = Check on all variants of the world and on all robots of this step
page-lesson-everywhere-stop = Stop checking
page-lesson-everywhere-title = All variants and robots
page-lesson-everywhere-progress = { $done } of { $count } checked
page-lesson-everywhere-passed = { $passed } of { $count } passed
page-lesson-everywhere-yes = Your program works everywhere!
page-lesson-everywhere-no = Your program does not work everywhere yet.
page-lesson-attempt = { $variant ->
    [0] { $robot }, world as drawn
   *[other] { $robot }, variant { $variant }
}
page-lesson-replay = Watch
page-lesson-replay-of = Watch { $where }
