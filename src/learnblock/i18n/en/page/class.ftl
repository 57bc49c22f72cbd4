# A class: joining, the teacher's wall, the projector, and what pupils' pages show of it.

# $title is the name of the class, such as 7b.
page-class-title = Class { $title }

## Joining

page-class-word = What is the join word?
page-class-next = Next
page-class-name = What is your first name?
page-class-known = I have been here before
page-class-new = I am new here
page-class-back = Back
page-class-pictures = Tap your four pictures
page-class-chosen = { $count } of 4 pictures
# $name is a first name.
page-class-hello = Hello, { $name }!
page-class-go-on = Go on
page-class-not-me = I am not { $name }
page-class-remember = Welcome, { $name }!
page-class-remember-text = These are your secret pictures. Remember them in this order, or write them down: you need them next time.
page-class-remembered = I'll remember them
page-class-picture-apple = Apple
page-class-picture-ball = Ball
page-class-picture-bell = Bell
page-class-picture-boat = Boat
page-class-picture-car = Car
page-class-picture-cloud = Cloud
page-class-picture-fish = Fish
page-class-picture-flower = Flower
page-class-picture-heart = Heart
page-class-picture-house = House
page-class-picture-key = Key
page-class-picture-moon = Moon
page-class-picture-star = Star
page-class-picture-sun = Sun
page-class-picture-tree = Tree
page-class-picture-umbrella = Umbrella

## The wall

page-class-no-key = This page is the teacher's. Open the address of the wall that LearnBlock printed when it started.
page-class-pupils = Pupils
# $count is the number of pupils whose pages are open.
page-class-here = { $count ->
        [0] No pupils are here yet
        [one] 1 pupil is here
       *[other] { $count } pupils are here
    }
page-class-word-is = join word: { $word }
page-class-go-to = Open
page-class-type-word = and type
page-class-open-door = New pupils can join
page-class-renew-word = New join word
page-class-eyes-up-button = Eyes up
page-class-stop-all = Stop all robots
page-class-hand-out = Hand out a lesson
page-class-hint-all = Hint for everybody
page-class-projector = Projector
page-class-export-all = Download all work
page-class-open = Open
page-class-hint = Hint
page-class-more = More for { $name }
page-class-project = Show on the projector, without the name
page-class-unproject = Show the join word on the projector
page-class-renew-pin = New pictures
page-class-export = Download the work
page-class-remove = Delete
# $count is the number of pupils in the class, $names are first names.
page-class-knocking = { $count } { $count ->
        [one] pupil has
       *[other] pupils have
    } joined. Waiting for you: { $names }
# $count is a number.
page-class-let-in = Let up to { $count } more join
page-class-let-in-not = Don't let them in
page-class-remove-several = Delete several…
page-class-remove-which = Choose the pupils to delete with everything that they have made. The last ones to join come first.
page-class-remove-title = Delete { $name }?
page-class-remove-text = This deletes everything that { $name } has made in this class. It can't be undone. Download the work first if you want to keep it.
page-class-remove-not = Cancel
page-class-pin-of = New pictures for { $name }
page-class-pin-text = Tell them to the pupil. The old ones no longer work.
page-class-hint-to = Hint for { $name }
page-class-hint-text = What should the pupil look at?
page-class-hint-send = Send
page-class-world-of = The world of { $name }
page-class-world-shown = A pupil's world
# $title is that of a lesson.
page-class-step = { $title } · step { $step } of { $steps } · { $stars } ★
page-class-state-idle = Editing
page-class-state-starting = Starting
page-class-state-running = Running
page-class-state-paused = Paused
page-class-state-held = Paused
page-class-state-input = Waiting for an answer
page-class-state-done = Ended
page-class-state-ended = Ended
page-class-need-hand = Asks for help
page-class-need-stuck = Stuck for { $minutes } min
page-class-need-error = Has an error
page-class-need-quiet = Quiet for { $minutes } min
page-class-need-away = Not here

## On a page that shows a pupil's program

page-class-hand = I need help
page-class-notes = From your class
page-class-hint-from = Your teacher:
page-class-asked = Your teacher would like to write in your program.
page-class-let = Let them write
page-class-let-not = Not now
page-class-writes = Your teacher can write in your program.
page-class-enough = That's enough
page-class-looking = You are looking at the program of { $name }.
page-class-ask = Ask to write
page-class-waiting = You have asked { $name } to let you write.
page-class-ask-not = Never mind
page-class-may = You can write in the program of { $name }.
page-class-stop-writing = Only look again
page-class-eyes-up = Eyes up!
page-class-eyes-up-text = Look at your teacher. Your program is safe.
