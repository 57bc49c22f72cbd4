# The dialog in which a teacher makes or changes a lesson.

page-maker-menu = Make a lesson of this project…
page-maker-make-title = Make a lesson
page-maker-change-title = Change lesson
page-maker-change = Change…
page-maker-parts = Parts of the lesson
page-maker-part-about = About the lesson
page-maker-part-teacher = For the teacher
# $title is the title of the step.
page-maker-step = { $number }. { $title }
page-maker-new-step = New step
page-maker-add-step = Add a step
page-maker-step-up = Move this step up
page-maker-step-down = Move this step down
page-maker-step-delete = Delete this step
page-maker-languages = Language you write in
# $text is the text in another language.
page-maker-fallback = Shown until you write it: { $text }
page-maker-save = Save lesson
page-maker-saved = “{ $title }” is in your lessons. You find it on the start page.
page-maker-is-saved = Saved
page-maker-not-saved = Not saved yet
page-maker-unsaved = “{ $title }” is not saved.
page-maker-go-on = Go on editing
page-maker-discard = Discard changes
page-maker-problems = { $count ->
    [one] 1 thing is missing or wrong:
   *[other] { $count } things are missing or wrong:
}
page-maker-place-step = Step { $number }
page-maker-place-title = Title
page-maker-place-level = Level
page-maker-place-minutes = Minutes
page-maker-place-aims = Aims
page-maker-place-robots = Robots for this lesson
page-maker-place-text = Instructions
page-maker-place-program = First program
page-maker-place-solution = Solution
page-maker-place-world = World
page-maker-place-blocks = Blocks
page-maker-place-variants = Variants
page-maker-place-seconds = Seconds
page-maker-place-check = Checks
page-maker-place-hint = Hints
page-maker-place-quiz = Question
page-maker-place-puzzle = Puzzle
page-maker-place-partners = Other robots

## About the lesson

page-maker-title = Title
page-maker-level = Level
page-maker-minutes = Minutes
page-maker-aims = Aims
page-maker-aims-help = What pupils learn, in short sentences.
page-maker-aim-number = Aim { $number }
page-maker-aim = What pupils learn
page-maker-add-aim = Add an aim
page-maker-robots = Robots for this lesson
page-maker-robots-help = The robots that the lesson is meant for.
page-maker-usual-robot = Usual robot

## A step

page-maker-step-title = Title of the step
page-maker-phase = Kind of step
page-maker-text = Instructions (Markdown)
page-maker-text-help = A code block that begins with ```blocks is drawn as blocks.
page-maker-preview = What pupils see
page-maker-as-before = As in the step before
page-maker-program = Program to begin with
page-maker-program-text = First program
page-maker-empty = Empty
page-maker-in-blocktext = In Block-Text
page-maker-in-python = In Python
page-maker-take-program = Take the open program
page-maker-world = World
page-maker-robots-world = The robot's usual world
page-maker-blocks = Blocks shown
page-maker-all-blocks = All blocks
page-maker-some-blocks = { $count } chosen blocks
page-maker-variants = Variants of the world
page-maker-seconds = Longest run (seconds)
page-maker-keys = Keys that are pressed
page-maker-keys-help = When the checks run without a player, these keys are pressed. The times are the robot's, so every run is the same.
page-maker-press = Press { $number }
page-maker-add-press = Add a press
page-maker-press-key = Key
page-maker-press-at = First at (seconds)
page-maker-press-seconds = Held for (seconds)
page-maker-press-times = How many times
page-maker-press-every = Seconds from one to the next
page-maker-solution-title = For the teacher only
page-maker-solution = Solution
page-maker-no-solution = No solution
page-maker-take-solution = Take the open program as the solution
page-maker-solution-text = Program of the solution

## Checks

page-maker-checks = Checks
page-maker-checks-help = Goals that LearnBlock looks for in what the robot did and in the program.
page-maker-check = Check { $number }
page-maker-check-unfinished = Fill in the fields to see this check in words.
page-maker-add-check = Add a check
page-maker-kind = What is checked
page-maker-say = Other words for pupils (optional)
page-maker-optional = Bonus: earns a star of its own
page-maker-none = (none)
page-maker-lines-help = One in each line
page-maker-kind-goals = Goals of the world are reached
page-maker-kind-happens = Something happens
page-maker-kind-never = Something never happens
page-maker-kind-in-order = Things happen in order
page-maker-kind-on-line = The robot stays on a line
page-maker-kind-drives = The robot drives a distance
page-maker-kind-ends-at = The robot ends at a place
page-maker-kind-turns = The robot has turned by an angle
page-maker-kind-ends = The program ends by itself
page-maker-kind-prints = The program prints lines
page-maker-kind-python = A function in checks.py
page-maker-kind-uses = The program uses something
page-maker-kind-size = The program is short
page-maker-event = What happens
page-maker-event-number = Event { $number }
page-maker-add-event = Add an event
page-maker-event-goal = A goal is reached
page-maker-event-shows = The robot shows something
page-maker-event-says = The robot says something
page-maker-event-prints = The program prints a line
page-maker-event-calls = The program calls a skill
page-maker-event-sends = The program sends a message
page-maker-event-collision = The robot bumps into something
page-maker-event-at = The robot comes to a place
page-maker-event-stands = The robot stands still
page-maker-key-goals = Goals (none: all)
page-maker-key-within = Within (seconds, optional)
page-maker-key-at-least = At least
page-maker-key-at-most = At most (optional)
page-maker-key-line = Line
page-maker-key-share = Share of the time (0 to 1)
page-maker-key-distance = Largest distance from the line (mm)
page-maker-key-least = Shortest way (mm)
page-maker-key-x = X (mm)
page-maker-key-y = Y (mm)
page-maker-key-radius = Radius (mm)
page-maker-key-heading = Heading (°, optional)
page-maker-key-angle = Largest error of the heading (°)
page-maker-key-by = Angle (°, clockwise)
page-maker-key-tolerance = Largest error (°)
page-maker-key-lines = Lines
page-maker-key-construct = Part of a program
page-maker-key-skill = Skill
page-maker-key-function = Function
page-maker-key-blocks = Blocks at most
page-maker-key-name = Goal
page-maker-key-what = Text (* matches anything)
page-maker-key-message = Message
page-maker-key-thing = Object (* matches any)
page-maker-key-seconds = Seconds

## Hints and questions

page-maker-hints = Your own hints
page-maker-hints-help = LearnBlock has hints of its own. Yours come first.
page-maker-hint = Hint { $number }
page-maker-add-hint = Add a hint
page-maker-hint-check = When this check fails
page-maker-any-check = Any check
page-maker-hint-level-1 = First: where to look
page-maker-hint-level-2 = Then: which part (optional)
page-maker-hint-level-3 = At last: how, in general (optional)
page-maker-quiz = Question
page-maker-quiz-on = Ask a question in this step
page-maker-question = Question
page-maker-answer = Answer { $number }
page-maker-answer-text = Answer
page-maker-answer-right = This answer is right
page-maker-because = Why it is right or wrong (optional)
page-maker-add-answer = Add an answer
page-maker-puzzle = Puzzle
page-maker-puzzle-on = Let pupils put the lines of a program in order
page-maker-puzzle-program = Program in the right order (Block-Text)
page-maker-puzzle-also = Right order { $number }
page-maker-puzzle-also-program = The same lines in another order that is also right (Block-Text)
page-maker-add-order = Add another right order
page-maker-distractors = Lines that don't belong to it

## For the teacher

page-maker-teacher-help = Pupils never get these notes, nor the solutions.
page-maker-notes = Notes for the teacher
page-maker-trial = Try the checks
page-maker-trial-help = Runs each solution on all robots and in all variants, and says which checks it meets.
page-maker-trial-start = Try the checks on the solutions
page-maker-trial-stop = Stop
page-maker-trial-done = { $done } of { $count } runs
page-maker-trial-none = No step has a solution yet.
page-maker-tried-solution = Step { $step }: the solution passes in { $right } of { $attempts } runs.
page-maker-tried-wrong = Step { $step }: a wrong program fails in { $right } of { $attempts } runs, as it should.
page-maker-tried-none = Step { $step } has checks, but no solution.
page-maker-downloads = Hand on the lesson
page-maker-downloads-help = The lesson is saved first. Pupils open the file on the start page.
page-maker-download-pupils = Download for pupils
page-maker-download-teacher = Download with the teacher's part
