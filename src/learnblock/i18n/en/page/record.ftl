# A pupil over weeks: lessons, stars, hints, hand-ins and aims; for pupil, teacher and parents.

page-record-title = Pupil record
page-record-own = My record
page-record-of-pupil = Record
page-record-back = My projects
page-record-print = Print
page-record-print-meeting = Print for the meeting
page-record-delete = Delete…
page-record-refused = Only the pupil and the teacher can see this record. Join the class again, or open the teacher's wall first.
page-record-lost = The class doesn't answer. Is it open? Reload the page to try again.
page-record-none = No lesson started yet.
page-record-finished = Finished lessons
# $count is the number of lessons that were started.
page-record-of-begun = of { $count } started
page-record-of = of { $count }
page-record-hints = Hints
page-record-no-hints = none
page-record-in-lessons = { $count ->
        [one] in 1 lesson
       *[other] in { $count } lessons
    }
# How many hand-ins were improved after they were handed back.
page-record-improved = { $count ->
        [one] 1 improved
       *[other] { $count } improved
    }
page-record-lessons = Lesson by lesson
page-record-date = Date
page-record-step = step { $step } of { $steps }
page-record-waits = handed in
page-record-aims = Aims
page-record-aims-from = based on what the programs did
# $lesson is the title of a lesson.
page-record-shown = Shown in { $lesson }
page-record-on-the-way = In progress: { $stars } of { $all } stars in { $lesson }
# The dates of a term choose what is counted.
page-record-term = Term
page-record-term-help = Counts the lessons last worked on within these dates, and what was handed in then.
page-record-from = From
page-record-to = To
page-record-always = All dates
page-record-none-then = Nothing was done within these dates.
page-record-standards = Standards
page-record-all-standards = All standards
