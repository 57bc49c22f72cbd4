# A class: joining, the teacher's wall, the projector, and what pupils' pages show of it.

# $title is the name of the class, such as 7b.
page-class-title = Class { $title }

## Joining

page-class-join = Join class { $title }
page-class-join-text = No account and no e-mail. Your work stays in this room.
# On a phone: word, name and pictures.
page-class-join-step = Step { $step } of 3
page-class-word = 1 · Join word, from the board
page-class-next = Next
page-class-name = 2 · Your first name
# $name has several words.
page-class-is-first-name = { $name } is my first name
page-class-whether = Have you been here before?
page-class-known = I have been here before
page-class-new = I am new here
page-class-back = Back
page-class-given = You will get four secret pictures, with which you find your work again on any device.
page-class-pictures = 3 · Tap your four secret pictures
page-class-take-back = Take the last picture back
page-class-forgotten = Forgotten? Your teacher can give you new ones.
page-class-join-do = Join
# $count is the number of pictures that are missing.
page-class-join-more = Join · { $count } more
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
page-class-go-to = Open
page-class-type-word = and type
page-class-open-or-scan = Open in the browser, or scan
page-class-name-and-pictures = Your first name and your four pictures
page-class-join-address = Join address
# At a hub.
page-class-log-in = Log in as at school
page-class-open-door = New pupils can join
page-class-renew-word = New join word
page-class-sharing = Let pupils play in pairs
page-class-showing = Let pupils show each other programs
page-class-eyes-up-button = Eyes up
page-class-stop-all = Stop all robots
page-class-hand-out = Hand out a lesson
page-class-hint-all = Hint for everybody
page-class-projector = Projector
page-class-export-all = Download all work
page-class-print-all = Print all programs
page-class-print-none = There is nothing to print yet, or the class does not answer.
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
# $names are first names, as a list.
page-class-lacks-lesson = The lesson did not reach { $names }. Hand it out to them again; if that does not help, stop their servers at the hub first.
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
page-class-state-help = Needs help
page-class-state-stuck = Stuck { $minutes } min
page-class-state-running = Running
page-class-state-editing = Editing
page-class-state-handed-in = Handed in
page-class-state-not-begun = Not begun
page-class-state-away = Away
# How many pupils are in a state; a number follows.
page-class-filters = Which pupils are shown
page-class-all = All
page-class-filter-help = Needs help
page-class-filter-stuck = Stuck
page-class-filter-running = Running
page-class-filter-editing = Editing
page-class-filter-handed-in = Handed in
page-class-filter-not-begun = Not begun
page-class-filter-away = Away
page-class-order = Order
page-class-order-need = Needs help first
page-class-order-name = By name
page-class-order-step = Farthest first
# While the pointer is over the tiles, they keep their places.
page-class-changes = { $count ->
        [one] 1 change · Sort
       *[other] { $count } changes · Sort
    }
page-class-lost = The class doesn't answer: it is closed, or its computer is asleep. What pupils' pages showed as saved is saved; changes made since then are kept on their devices.
page-class-keys = Arrow keys go from pupil to pupil, and a letter to the next name that begins with it. Enter opens the pupil's page, H writes a hint, Shift+F10 opens the menu. F6 goes to the next part of the wall.
page-class-open = Open
page-class-look = Look
# What a pupil has written.
page-class-said = “{ $question }”
page-class-asks = { $name } asks for help.
page-class-join-word = Join word
page-class-more-tools = More
# Of a lesson: 1 to 4.
page-class-level = Level { $level }
page-class-every-robot = every robot
page-class-left = { $minutes } min left
page-class-minutes = { $minutes } min
page-class-side = The class
page-class-waiting-for-you = Waiting for you
page-class-none-waiting = No pupil is waiting.
page-class-more-wait = and { $count } more
# $project is the name of a project.
page-class-shows = shows “{ $project }”
page-class-shown = Shown to classmates
# $name and $classmate are pupils, $project is the name of a project.
page-class-shown-to = “{ $project }”: { $name } to { $classmate }
page-class-tried = step { $step } · { $tries } { $tries ->
        [one] try
       *[other] tries
    }
page-class-where = Where the class is
page-class-no-lesson = No lesson has been handed out.
# $what is a check of a lesson, or what was missed and by how much.
page-class-mistake = Step { $step }: { $count } of { $tried } miss this: { $what }
# $count is the number of pupils who have finished the lesson that is on, $title that of the next one.
page-class-next-lesson = { $title }, for { $count ->
        [one] 1 who is ready
       *[other] { $count } who are ready
    }
page-class-next-given = { $title } is open on the pages of { $count ->
        [one] 1 pupil
       *[other] { $count } pupils
    }.
page-class-hand-ins = Hand-ins
page-class-some-of = { $count } of { $all }
page-class-no-hand-ins = No pupil has finished yet.
# Of a hand-in, if the pupil has another step open, or another lesson with $title.
page-class-of-step = step { $step }
page-class-of-lesson = { $title }, step { $step }
page-class-pupil = Pupil
page-class-stars = Stars
page-class-tries = Tries
page-class-mark = Mark
page-class-to-mark = to mark
page-class-done = finished
page-class-hint-kept = The connection is lost. Your hint is kept: send it again once you are back online.
page-class-hint-text-all = What should everybody look at?
page-class-lessons = Lessons
page-class-find-lesson = Find a lesson
page-class-add-lesson = Add my lesson…
page-class-delete-lesson-text = The file of the lesson is deleted on this computer. Pupils who have begun the lesson keep it.
page-class-no-such-lesson = No lesson has these words.
page-class-own-lessons = My lessons { $count }
page-class-lesson-on = On now
page-class-lesson-next = Next
page-class-lesson-own = Mine
page-class-to-everyone = It opens on every pupil's page, and for pupils who come later.
page-class-hand-out-do = Hand out
page-class-hand-out-one = Hand out a lesson…
page-class-receiving = Who gets the lesson
page-class-to-all = To everyone
# $count is a number of pupils.
page-class-to-some = { $count ->
        [0] To some…
        [one] To 1 pupil
       *[other] To { $count } pupils
    }
page-class-to-these = It opens on these pupils' pages. Those who are away get it when they come back.
page-class-from = The step to begin with
page-class-from-own = Where each pupil left off
# $title is that of a step.
page-class-from-step = From step { $step }: { $title }
# $title is that of a lesson.
page-class-step = { $title } · step { $step } of { $steps } · { $stars } ★

## On a page that shows a pupil's program

page-class-hand = I need help
page-class-question = What do you need help with?
page-class-told = Your teacher can see this
page-class-tell = Tell my teacher
page-class-no-help = I no longer need help
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
page-class-lost-saved = Your class doesn't answer. Everything you have made is saved. Keep working: it goes on when your teacher's computer is back.
page-class-lost-unsaved = Your class doesn't answer. Keep working: your changes are kept on this device, and are saved when your teacher's computer is back.
page-class-eyes-up = Eyes up!
page-class-eyes-up-text = Look at your teacher for a moment.
page-class-eyes-up-safe = Your program is safe. Your robot waits.
