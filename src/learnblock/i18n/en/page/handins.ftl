# What pupils hand in: the teacher's page with the hand-ins, and what pupils' pages show.

## The hand-ins

page-handins-title = Hand-ins
page-handins-wall = Wall
# $count is a number of hand-ins.
page-handins-check = Check { $count }
page-handins-check-again = Check again
page-handins-checking = Checking
page-handins-progress = { $done } of { $total } runs
page-handins-stop = Stop
page-handins-back-all = Hand back { $count }
page-handins-tables = Tables
page-handins-csv = Marks (CSV)
page-handins-moodle = Marks for Moodle (CSV)
page-handins-results = All runs (CSV)
page-handins-report = Report of all programs
page-handins-lesson = Lesson
page-handins-steps = Steps
page-handins-starts = { $count ->
        [one] tried once
       *[other] each tried from { $count } starts
    }
page-handins-no-lesson = No pupil is working on a lesson yet. Hand one out on the wall.
page-handins-none = Step { $step } has no hand-ins yet.
page-handins-often = Most often:
page-handins-pupils = ({ $count } pupils)
page-handins-pupil = Pupil
page-handins-stars-head = Stars
page-handins-tries = Tries
page-handins-missed = What was missed
page-handins-mark = Mark
page-handins-state-to-check = To check
page-handins-state-to-mark = To mark
page-handins-state-marked = Marked, not handed back yet
page-handins-state-handed-back = Handed back
page-handins-state-improving = Improving
page-handins-to-mark = to mark
page-handins-unchecked = not checked yet
page-handins-nothing = nothing
page-handins-stars = { $stars } of 3 stars
page-handins-not-begun = not begun · no mark, not counted under any mistake
page-handins-not-handed-in = not handed in yet
page-handins-collect = Collect now
page-handins-at = { $tries ->
        [0] handed in { $time }
        [one] 1 try, handed in { $time }
       *[other] { $tries } tries, handed in { $time }
    }
page-handins-collected-at = { $tries ->
        [0] collected { $time }
        [one] 1 try, collected { $time }
       *[other] { $tries } tries, collected { $time }
    }
page-handins-nameless = Show without name
page-handins-nameless-title = A program for step { $step }
page-handins-previous = Previous pupil
page-handins-next = Next pupil
page-handins-program = Program
page-handins-checks = Checks
page-handins-met = { $met } of { $runs }
page-handins-check-first = Not checked yet: press Check to try it from all starts.
page-handins-why = Why?
page-handins-way = Where the robot of { $name } drove
page-handins-run-show = Show the run
page-handins-run-hide = From above
page-handins-run-of = The run of { $name }
page-handins-seconds = { NUMBER($seconds, maximumFractionDigits: 1) } s
page-handins-note = Note to
page-handins-about = About
page-handins-about-all = the whole program
page-handins-about-gone = { $line } (not in this program)
page-handins-your-mark = Your mark
page-handins-back = Hand back
page-handins-back-again = Hand back again
page-handins-earlier = Handed back so far: { $marks }

## Handing in, on the pupil's page

page-handins-own = Hand in
page-handins-own-again = Hand in again
page-handins-own-waits = Handed in. Your teacher looks at it.
page-handins-own-back = Your work is back
page-handins-own-mark = Your mark: { $mark }
page-handins-own-teacher = Your teacher:
page-handins-own-line = Look at: { $line }
page-handins-own-gone = (This was about { $line }, which is no longer in your program.)
page-handins-own-improve = Improve and hand in again
page-handins-your-run = Your run
page-handins-own-run = The run that you handed in
page-handins-own-later = Later
page-handins-own-improving = You are improving it. Hand it in again when you are ready.
