# The view of the program as blocks.

page-blocks-label = Program as blocks
page-blocks-more = { $count ->
    [one] 1 more block
   *[other] { $count } more blocks
}
page-blocks-fewer = Fewer blocks
# $robot: a robot's name. $device: what it lacks, such as: screen
page-blocks-missing = { $robot } has no { $device }
page-blocks-stand-in = { $robot } has no { $device }: you hear it on this computer
page-blocks-from-stage = From the stage { $stage } on
page-blocks-inserted = Added: { $block }
page-blocks-sheet = Blocks: { $group }
page-blocks-drop-to-delete = Drop here to delete
page-blocks-other = Other…
page-blocks-other-prompt = Which one?
page-blocks-piano = Piano
page-blocks-pin = Keep the palette open
page-blocks-unpin = Close the palette after use
page-blocks-help = Help
# $block: the words of the block
page-blocks-help-on = Help: { $block }
page-blocks-help-key = Explain block
page-blocks-help-values = Values
page-blocks-help-insert = Insert this block
page-blocks-help-range = a number from { $min } to { $max }
page-blocks-help-unit = { $range }, in { $unit }
page-blocks-help-robots = Works on: { $robots }.
page-blocks-help-all-robots = Works on every robot.
page-blocks-help-choice = one of: { $choices }
page-blocks-help-float = a number
page-blocks-help-int = a whole number
page-blocks-help-string = text
page-blocks-help-boolean = true or false
page-blocks-help-list = a list
page-blocks-help-apriltext = a tag's number or name
page-blocks-help-colour = a colour
page-blocks-help-angle = an angle in degrees, clockwise
page-blocks-search = Search
page-blocks-search-blocks = Search for blocks
page-blocks-search-program = Search in the program
page-blocks-previous = Previous
page-blocks-next = Next
page-blocks-close = Close
page-blocks-empty = Drag a block into the yellow one, then press Run.
page-blocks-empty-keys = Drag a block into the yellow one, then press Run. With the keyboard: Enter on a block, and F1 for help.
page-blocks-loading = Loading blocks…
page-blocks-rest = { $count ->
    [one] 1 more block
   *[other] { $count } more blocks
    }
page-blocks-open-rest = Show these blocks
page-blocks-failed = The blocks could not be loaded. Check that LearnBlock is running, then reload the page.
page-blocks-new-when = New event…
page-blocks-when-name = my_event
# The names of events that are ready to use: letters, digits and _ only.
page-blocks-name-lb-when-is-key-pressed = key_pressed
page-blocks-name-lb-when-is-bumped = bumped
page-blocks-name-lb-when-is-front-obstacle = obstacle_near
page-blocks-name-lb-when-received = message_received
page-blocks-name-lb-when-collected = thing_collected
page-blocks-name-lb-when-is-time-up = time_is_up
# The heading of events such as "when I collect a star".
page-blocks-in-a-game = In a game
page-blocks-when-prompt = Name of the new event:
page-blocks-zoom = Size of the blocks
page-blocks-zoom-in = Zoom in
page-blocks-zoom-out = Zoom out
page-blocks-zoom-reset = Reset zoom
page-blocks-breakpoint = Breakpoint: the program pauses before this block
page-blocks-add-breakpoint = Add breakpoint
page-blocks-remove-breakpoint = Remove breakpoint
page-blocks-show-in-texts = Show in code
page-blocks-search-hint = Type to search for blocks
page-blocks-search-nothing = No matching blocks
page-blocks-search-found = { $count ->
    [one] 1 matching block
   *[other] { $count } matching blocks
    }
page-blocks-slider = slider
page-blocks-more-values = Show more values
page-blocks-angle = angle in degrees, clockwise
page-blocks-colour = colour
page-blocks-other-colour = custom colour
page-blocks-tag = tag number or name
page-blocks-colour-red = red
page-blocks-colour-orange = orange
page-blocks-colour-yellow = yellow
page-blocks-colour-green = green
page-blocks-colour-cyan = cyan
page-blocks-colour-blue = blue
page-blocks-colour-purple = purple
page-blocks-colour-pink = pink
page-blocks-colour-white = white
page-blocks-colour-black = black
page-blocks-own = My blocks
page-blocks-new-own = New block…
page-blocks-all-own = Manage my blocks…
page-blocks-edit-own = Edit this block's code…
page-blocks-call = function call
page-blocks-call-value = function result

# What children call things that the blocks name otherwise: words to search for, lower case.
page-blocks-meaning-loop = loop, again, cycle, iterate
page-blocks-meaning-condition = condition, choose, decide
page-blocks-meaning-pause = pause, delay, sleep
page-blocks-meaning-speed = speed, velocity, fast, slow
page-blocks-meaning-go = go, move, forward, motor, engine, wheels
page-blocks-meaning-rotate = rotate, spin, corner
page-blocks-meaning-halt = halt, brake
page-blocks-meaning-lamp = lamp, light, bulb, colour, color
page-blocks-meaning-sensor = sensor, sonar, ultrasonic, wall, distance
page-blocks-meaning-face = face, feeling, emotion, smile
page-blocks-meaning-sound = sound, music, speak, talk, tone, beep
page-blocks-meaning-photo = photo, image
page-blocks-meaning-random = dice, chance, luck
page-blocks-meaning-show = write, display, text
page-blocks-meaning-module = module, library, package
page-blocks-meaning-exception = exception, error, catch, handle
page-blocks-meaning-object = object, method, attribute, property, object-oriented
page-blocks-meaning-switch = switch, pattern, choose among cases
page-blocks-meaning-comprehension = list comprehension
page-blocks-meaning-anonymous = anonymous function, lambda
page-blocks-meaning-file = open a file, read, context
page-blocks-meaning-slice = slice, substring
page-blocks-meaning-tuple = tuple, pair, swap, unpack
