# The start page.

page-start-home = Home
page-start-places = Parts of the page
page-start-lessons = Lessons
page-start-examples = Examples
page-start-projects = My projects
page-start-teachers = For teachers

## What to do first

# $day is today, yesterday or a date.
page-start-last = Last project · { $day }
page-start-continue-text = Go on where you stopped.
page-start-continue = Continue
page-start-first = Your first program
page-start-first-text = Watch it, then change it.
page-start-try = Try it

## In a class

page-start-handed-out = From your teacher
page-start-begin = Begin
page-start-hand-ins = Handed in
page-start-no-hand-ins = When you hand in a step of a lesson, it appears here, and so does what your teacher says about it.
page-start-improving = You are improving it
# $lesson is the title of a lesson.
page-start-step = { $lesson } · step { $step }

## Robots

page-start-robots = Which robot do you have?
page-start-no-robot = No robot? A simulated one drives here.
page-start-robot-ready = { $robot } is ready
page-start-robot-charge = { $robot } is ready · { $percent }%
page-start-connect = Connect

## Lessons and examples

page-start-stage = Stage
page-start-stage-starter = Starter · 8–10
page-start-stage-explorer = Explorer · 10–13
page-start-stage-coder = Coder · 13–16
page-start-examples-title = Examples
page-start-examples-help = Open one, press Run, change it
# $count is the number of cards, or of projects.
page-start-all = All { $count }
page-start-all-examples = All examples

## Projects

page-start-new = New
page-start-import = Import…
page-start-no-projects = Your projects appear here. Start with an example or a new program, or drop a file here.
page-start-open = Open
page-start-copy = Copy…
page-start-more = More for { $name }

## For teachers

page-start-teachers-blocks-title = Choose the blocks
page-start-teachers-blocks = In the project's menu, Choose blocks limits the palette to what a lesson needs. The choice is saved in the project.
page-start-teachers-notes-title = Notes and solutions of every lesson
page-start-teachers-notes = The menu of a lesson has notes, the solution of each step and typical wrong programs with their hints. Copy and change makes your own lesson of it.
page-start-teachers-lesson-title = Make your own lessons
page-start-teachers-lesson = In the project's menu, Make a lesson of this project writes a lesson with steps and checks. It appears among the lessons, and you can download it for pupils, without the solutions.
page-start-teachers-share-title = Share an exercise as a file
page-start-teachers-share = Download a project and give the file to your class. Pupils drop it onto this page. It contains the program, its world, tag names and custom blocks.
page-start-teachers-robots-title = Several robots in one world
page-start-teachers-robots = The + beside the robot's tab adds another robot with its own program, to play football or send messages.
page-start-teachers-grade-title = Grade a whole class
page-start-teachers-grade = The command “learnblock grade” tries all programs that a class has handed in, with the checks of a lesson, and writes a table and a page. No mark is final.
page-start-teachers-grade-more = What learnblock grade does
page-start-teachers-batch-title = Check all programs at once
page-start-teachers-batch = The command “learnblock run --variants” runs a program in each variant of a world. From Python, learnblock.running.batch runs the programs of a whole class, and lists the goals they reached.

# The dialog about learnblock grade. The command itself is shown between the first two texts.
page-start-grade-title = Grade a class with learnblock grade
page-start-grade-begin = Put what your pupils have handed in (.learnblock, .bt or .py) into a folder: a file or a folder for each pupil. Then open a terminal and write:
page-start-grade-runs = Every program runs in every variant of the lesson's world and on every robot of the step. It can't reach your files, the network or the other programs.
page-start-grade-results = The folder “results” then has a table, results.csv, and a page, results.html: the checks that each program met and why not, the ways that the robots drove, hints that fit, groups of programs with the same mistake, and programs that are alike.
page-start-grade-again = A grading that you stop goes on where it was. The same programs always get the same results.
page-start-grade-final = No mark is final. The results come from fixed rules, and no AI is involved: you decide what they are worth.
page-start-grade-more = “learnblock grade --help” and docs/grading.md have all options, such as several computers at once.
page-start-grade-back = Back
