# What the start page has for teachers.

page-teachers-about = A class runs on this computer. No accounts, and pupils install nothing.
page-teachers-elsewhere = Classes are on the computer that runs LearnBlock: open this page there to start one.
page-teachers-topics = Before and after the lesson

## Classes

page-teachers-classes = My classes
page-teachers-none = Your classes appear here. Start the first one, or open the file of a class that you have prepared.
page-teachers-open-file = Open a class file
page-teachers-is-open = Open
page-teachers-is-closed = Closed
# $count is a number.
page-teachers-pupils = { $count ->
        [0] No pupils yet
        [one] { $count } pupil
       *[other] { $count } pupils
    }
# $day is a day, such as "today" or "12 November".
page-teachers-used = last used { $day }
# $lesson is the title of a lesson.
page-teachers-begins = begins with { $lesson }
page-teachers-open = Open
page-teachers-opening = Opening…
page-teachers-close = Close
page-teachers-closing = Saving everything…
page-teachers-wall = Go to the wall
page-teachers-download = Download the class
page-teachers-delete = Delete
page-teachers-delete-title = Delete class { $title }?
page-teachers-delete-text = Everything that its pupils have made, and their names, are deleted from this computer. This can't be undone.
page-teachers-delete-type = Type { $title } to delete it
page-teachers-keep = Keep

## Starting one

page-teachers-start = Start a class
page-teachers-name = Name, such as 7b
page-teachers-lesson = First lesson
page-teachers-no-lesson = None
page-teachers-blocks = Blocks in pupils' own projects
page-teachers-start-button = Start class
page-teachers-next = Next you see the wall, with the join word, the address and a QR code for the projector. A lesson shows its own blocks.

## What is kept

page-teachers-kept = What is kept about children
page-teachers-kept-names = First name and four pictures, which replace a password. Never a surname, an e-mail address or a device.
page-teachers-kept-work = Programs, runs and stars.
page-teachers-kept-here = Only on this computer. Nothing is sent anywhere, and no AI judges a child.
page-teachers-kept-until = Until you delete it: one child on the wall, or a class here.
