# The help of the page: one block, and the search over blocks, lessons and docs.

page-help-title = Help
page-help-search = Search blocks, lessons and docs
page-help-hint = Type a word, such as “turn”, “loop” or “Wi-Fi”.
page-help-nothing = Nothing found for “{ $words }”. Try a shorter word, or another one.
page-help-blocks = Blocks
page-help-lessons = Lessons
page-help-docs = Docs
page-help-back = Back to the results
# How many results there are, for screen readers.
page-help-found =
    { $count ->
        [0] Nothing found
        [one] 1 result
       *[other] { $count } results
    }
page-help-example = Example
page-help-play = Play again
page-help-open-example = Open the example as a project
page-help-elsewhere = Also called

# Exactly as the blocks are called there, with their usual values.
page-help-name-start = Scratch: when ⚑ clicked · MakeCode: on start
page-help-name-repeat = Scratch: repeat (10) · MakeCode: repeat (4) times
page-help-name-forever = Scratch and MakeCode: forever
page-help-name-if = Scratch and MakeCode: if … then
page-help-name-while = Scratch: repeat until, which asks the opposite · MakeCode: while … do
page-help-name-count = MakeCode: for index from 0 to (4)
page-help-name-each = MakeCode: for element value of list
page-help-name-wait-until = Scratch: wait until
page-help-name-wait = Scratch: wait (1) seconds · MakeCode: pause (ms) (100)
page-help-name-set = Scratch: set [my variable] to (0) · MakeCode: set [variable] to (0)
page-help-name-change = Scratch: change [my variable] by (1) · MakeCode: change [variable] by (1)
page-help-name-print = Scratch: say (Hello!)
page-help-name-ask = Scratch: ask (What's your name?) and wait, and answer
page-help-name-define = Scratch: define, in My Blocks · MakeCode: function
page-help-name-random = Scratch: pick random (1) to (10) · MakeCode: pick random (0) to (10)
page-help-name-arithmetic = Scratch: ( ) + ( ), ( ) - ( ), ( ) * ( ), ( ) / ( )
page-help-name-remainder = Scratch: ( ) mod ( ) · MakeCode: remainder of ( ) ÷ ( )
page-help-name-round = Scratch and MakeCode: round ( )
page-help-name-compare = Scratch: ( ) > (50), ( ) < (50), ( ) = (50)
page-help-name-and = Scratch and MakeCode: and, or
page-help-name-not = Scratch and MakeCode: not
page-help-name-join = Scratch: join (apple) (banana) · MakeCode: join
page-help-name-list = Scratch: Make a List · MakeCode: array of
page-help-name-item = Scratch: item (1) of [list], which counts from 1
page-help-name-replace = Scratch: replace item (1) of [list] with (thing)
page-help-name-length = Scratch: length of [list]
page-help-name-contains = Scratch: [list] contains (thing)?
page-help-name-comment = Scratch and MakeCode: Add Comment
page-help-name-move = Scratch: move (10) steps
page-help-name-turn = Scratch: turn ↻ (15) degrees
page-help-name-point = Scratch: point in direction (90)
page-help-name-go = Scratch: glide (1) secs to x: (0) y: (0)
page-help-name-key = Scratch: key (space) pressed?
page-help-name-timer = Scratch: timer
page-help-name-reset-timer = Scratch: reset timer
page-help-name-broadcast = Scratch: broadcast (message1) · MakeCode: radio send
page-help-name-received = Scratch: when I receive [message1] · MakeCode: on radio received
page-help-name-pen-down = Scratch: pen down
page-help-name-pen-up = Scratch: pen up
page-help-name-pen-colour = Scratch: set pen color to
page-help-name-pen-size = Scratch: set pen size to (1)
page-help-name-erase = Scratch: erase all
page-help-name-show-text = MakeCode: show string (Hello!)
page-help-name-show-number = MakeCode: show number (0)
page-help-name-clear = MakeCode: clear screen
page-help-name-note = Scratch: play note (60) for (0.25) beats · MakeCode: play tone
page-help-name-light = MakeCode: light level
