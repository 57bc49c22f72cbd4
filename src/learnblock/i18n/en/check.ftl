# Errors and warnings in a program that can be parsed: names, arguments, devices, likely mistakes.

## Names

check-unknown-name = '{ $name }' has no value. Set it first: '{ $name } = ...'. If it is text, write it in quotes.
check-unknown-name-near = '{ $name }' has no value. Did you mean '{ $near }'?
check-read-before-set = '{ $name }' is used here before it is set. Write '{ $name } = ...' above.
check-defined-below = '{ $name }' is used here, but defined only on line { $line }. Move its definition above this line.
check-when-as-variable = '{ $name }' is a 'when'. Write 'state_{ $name }' to check whether it is active.
check-function-as-variable = '{ $name }' is a function. Write '{ $name }(...)' to call it.
check-skill-as-name = '{ $name }' is a skill of the robot. Write '{ $skill }(...)' to use it.
check-unknown-function = There is no function '{ $name }'. Define it with 'def { $name }(...)', or check the name.
check-unknown-function-near = There is no function '{ $name }'. Did you mean '{ $near }'?
check-without-robot = This program has no robot. Delete the line 'without robot'.
check-robot-not-first = 'robot(...)' must come before everything else. Move it to the top.
check-unknown-skill = There is no skill '{ $name }'. The palette shows all skills.
check-unknown-skill-near = There is no skill '{ $name }'. Did you mean '{ $near }'?
# $advice: one of the two messages below
check-unknown-skill-meant = There is no skill '{ $name }'. { $advice }
check-unknown-function-meant = There is no function '{ $name }'. { $advice }
check-write = Write '{ $instead }'.
check-keeps-driving = '{ $instead }' drives at 40 mm/s until the next command. To stop after 2 seconds, write '{ $sleep }' and '{ $stop }' below it.
check-range = Block-Text has no 'range'. Write 'repeat { $count }:', or 'for i from { $first } to { $last }:' to count.
check-function-as-skill = '{ $name }' is your own function. Call it without 'function.'.
# $reason: file, line and message
check-skill-with-error = The skill '{ $name }' can't be used because of an error in its file. { $reason }
check-unknown-when = There is no 'when { $name }'. Write one, or check the name.
# $name: of an event that has no condition
check-never-started = Nothing starts 'when { $name }', so it never runs. Write 'activate { $name }' where it should start, or give it a condition: 'when { $name } = ...:'.
check-never-started-python = Nothing starts the event '{ $name }', so it never runs. Write '{ $name }.activate()' where it should start, or give it a condition: '@robot.when(lambda: ...)'.
check-events-never-run = This loop never ends, so events such as '{ $name }' never run. Put what the loop repeats into an event that always runs, such as 'when drive = True:', or end the loop with 'if ...:' and 'break' in it.
check-events-never-run-python = This loop never ends, so events such as '{ $name }' never run. Put what the loop repeats into a function below '@robot.when(lambda: True)', or end the loop with 'if ...:' and 'break' in it.
check-events-held-up = Once this loop has begun, it never ends, so events such as '{ $name }' don't run any more. End the loop with 'if ...:' and 'break' in it.
check-events-held-up-by-event = Once this loop has begun, it never ends, so other events such as '{ $name }' don't run any more. Remove 'forever:' and its 'end': the lines of an event are repeated anyway while it is active.
check-events-held-up-by-event-python = Once this loop has begun, it never ends, so other events such as '{ $name }' don't run any more. Remove 'while True:': the lines of an event are repeated anyway while it is active.
check-unknown-when-near = There is no 'when { $name }'. Did you mean '{ $near }'?
# $word: def or when
check-defined-twice = There is another '{ $word } { $name }' on line { $line }. Rename one or combine them.
check-function-and-variable = '{ $name }' is both a function and a variable. Rename one.
check-follows-condition = 'when { $name }' follows its condition, so '{ $word } { $name }' lasts one round at most. Put into the condition what should start or stop it.
check-follows-condition-python = The event '{ $name }' follows its condition, so '{ $name }.{ $word }()' lasts one round at most. Put into the condition what should start or stop it.
check-value-of-event = '{ $name }' belongs to 'when { $event }', so nothing else can have this name. { $value ->
    [time] Choose another name, or write 'deactivate { $event }' and 'activate { $event }' to start its time again.
   *[active] Choose another name, or write 'activate { $event }' or 'deactivate { $event }' to change its state.
}
check-value-of-event-python = '{ $event }.{ $value }' belongs to the event and can't be set. { $value ->
    [time] Write '{ $event }.deactivate()' and '{ $event }.activate()' to start its time again.
   *[active] Write '{ $event }.activate()' or '{ $event }.deactivate()' to change it.
}

## Libraries

check-unknown-library = There is no library '{ $name }', only: { $known }. Import its file with 'learnblock library import', or put { $name }.py next to the program.
check-unknown-library-near = There is no library '{ $name }'. Did you mean '{ $near }'?
check-no-libraries = There is no library '{ $name }'. Import its file with 'learnblock library import', or put { $name }.py next to the program.
check-not-imported = The skill '{ $skill }' belongs to the library '{ $library }'. Write 'import "{ $library }"' at the top of the program.

## Arguments. $call: such as function.turn

check-no-arguments = '{ $call }' takes no arguments. Leave its brackets empty.
# $parameters: their names
check-too-many-arguments = { $most ->
    [0] '{ $call }' takes no arguments. Leave its brackets empty.
    [one] '{ $call }' takes only 1 argument ({ $parameters }), not { $given }. Write '{ $instead }'.
   *[other] '{ $call }' takes only { $most } arguments ({ $parameters }), not { $given }. Write '{ $instead }'.
}
check-argument-count = { $count ->
    [0] '{ $call }' takes no arguments. Leave its brackets empty.
    [one] '{ $call }' takes 1 argument, not { $given }.
   *[other] '{ $call }' takes { $count } arguments, not { $given }.
}
check-argument-range = '{ $call }' takes { $least } to { $most } arguments, not { $given }.
check-too-few-arguments = { $least ->
    [one] '{ $call }' takes at least 1 argument, not { $given }.
   *[other] '{ $call }' takes at least { $least } arguments, not { $given }.
}
# $names: of the missing arguments
check-missing-argument = { $count ->
    [one] '{ $call }' needs a value for '{ $names }'.
   *[other] '{ $call }' needs values for: { $names }.
}
check-unknown-argument = '{ $call }' has no argument '{ $name }', only: { $known }.
check-unknown-argument-near = '{ $call }' has no argument '{ $name }'. Did you mean '{ $near }'?
check-no-named-arguments = '{ $call }' has no argument named '{ $name }'. Write only the values, without names.
check-number-expected = '{ $parameter }' of '{ $call }' must be a number, not text.
check-number-in-quotes = '{ $parameter }' of '{ $call }' must be a number, not text. Write { $number } without quotes.
check-negative-wait = The robot can't wait { $seconds } seconds. Write 0 or more.
# $value, $choices: as written in the program
check-outside-range = '{ $parameter }' of '{ $call }' is { $value } here. It should be between { $least } and { $most }.
check-unknown-choice = '{ $parameter }' of '{ $call }' is { $value } here. The choices are: { $choices }.
check-unknown-choice-near = '{ $parameter }' of '{ $call }' is { $value } here. Did you mean { $near }?
check-not-a-colour = '{ $parameter }' of '{ $call }' is { $value } here. Write a colour such as "#ff8800".
check-whole-number = 'for ... from ... to' counts in whole numbers, not { $number }.
check-text-for-number = This is text, but it must be a number.
check-counts-up = This loop never runs, because it counts up from { $start } to { $stop }. To count down, write 'for { $name } from { $start } to { $stop } step -1:'.
check-counts-up-python = This loop never runs, because it counts up and { $stop } is not above { $start }. To count down, write 'range({ $start }, { $stop }, -1)': it stops before { $stop }.
check-never-repeats = With 'repeat { $count }' the lines inside never run. Write a number above 0.
check-never-repeats-python = With 'range({ $count })' the lines inside never run. Write a number above 0.
check-wait-until = Waiting for a condition is no skill. Write 'wait until' and the condition, such as 'wait until function.is_front_obstacle()'.
check-idle-wait = Nothing changes this while the program waits here, so it waits forever or not at all. Ask the robot in it, such as '{ $skill }'.
check-unchanged-in-wait = Only other lines could change '{ $name }', and no other line runs while the program waits here. So it waits forever or not at all. Ask the robot in it, such as '{ $skill }'.
check-unchanged-in-loop = Nothing in this loop changes '{ $name }', and no other line runs meanwhile, so the loop never ends once it has begun. Change '{ $name }' in it, or write 'break' where it should end.
check-told-stays = '{ $name }' only repeats what the robot was last told to do, and nothing here tells it anything else. So the program stays here forever or not at all. Ask a sensor, such as '{ $skill }'.
# $name: such as state_go
check-state-in-wait = Events don't run while the program waits here, so '{ $name }' can't change: it waits forever or not at all. Move the lines below into 'when { $event }', or ask the robot, such as '{ $skill }'.
check-state-in-wait-python = Events don't run while the program waits here, so '{ $name }' can't change: it waits forever or not at all. Move the lines below into the event '{ $event }', or ask the robot, such as '{ $skill }'.
check-state-in-loop = Events don't run during this loop, so '{ $name }' can't change and the loop never ends once it has begun. Move its lines into 'when { $event }', or ask the robot, such as '{ $skill }'.
check-state-in-loop-python = Events don't run during this loop, so '{ $name }' can't change and the loop never ends once it has begun. Move its lines into the event '{ $event }', or ask the robot, such as '{ $skill }'.
# $name: such as time_go
check-time-stays = '{ $name }' stays 0 here, because nothing has started 'when { $event }' before. Write 'activate { $event }' above, or wait with '{ $sleep }'.
check-time-stays-python = '{ $name }' stays 0 here, because nothing has started the event '{ $event }' before. Write '{ $event }.activate()' above, or wait with '{ $sleep }'.
check-growing-list = This loop adds to '{ $name }' while it goes through it, so it never ends. Go through a copy: 'for { $target } in copy({ $name }):'.
check-growing-list-python = This loop adds to '{ $name }' while it goes through it, so it never ends. Go through a copy: 'for { $target } in { $name }.copy():'.
check-idle-loop = This loop does nothing, so it never ends. Write the lines to repeat inside it, or remove it.
check-step-zero = With 'step 0' the loop would never end. Write another step.

check-speed-as-angle = '{ $call }' takes a speed: the robot would keep turning at { $speed }°/s. Write '{ $turn }' to turn { $side ->
    [left] left
   *[other] right
} by { $speed } degrees.

## Types. $value, $values and $item: a part of the program

check-convert-to-number = '{ $value }' is text here, but a number is needed. Write 'int({ $value })'.
check-answer-for-number = What is typed in is always text, even a number such as 5. Write 'int({ $value })' to make it a number.
check-answer-changed = '{ $name }' holds what was typed in, which is always text, even 5. Write '{ $instead }'.
check-words-for-number = '{ $name }' holds text, such as "{ $text }", but a number is needed. Use a variable that holds a number.
check-number-without-quotes = A number is needed here, not text. Write { $number } without quotes.
check-dictionary-for-number = '{ $value }' is a dictionary here, but a number is needed. Write a key in square brackets behind it, such as '["Ana"]'.
check-list-for-number = '{ $values }' is a list here, but a number is needed. Write '{ $values }[0]' for its first item, or 'len({ $values })' for their number.
check-join-text = Only text can be added to text. Write 'str({ $value })'.
check-append = Only a list can be added to a list. Write 'append({ $values }, { $item })' to add one item.
check-append-python = Only a list can be added to a list. Write '{ $values }.append({ $item })' to add one item.
# $advice: one of the messages above
# $name: a variable; $value: what it is compared with
check-rounded = '{ $name }' is calculated with decimals, which computers round: 0.1 + 0.2 is 0.30000000000000004. So it may miss { $value } by very little. Write 'round({ $name }, 3)' in place of '{ $name }' here.
check-rounded-sum = Computers round decimals: 0.1 + 0.2 is 0.30000000000000004. So these two may differ by very little. Write 'round(..., 3)' around what is calculated.
check-never-equal = Text never equals a number. { $advice }
check-decimals = A whole number is needed here, but Python gives this one decimals, as in 5.0. Write '//' instead of '/', or 'int(...)' around it.
check-random-decimals = 'random' takes whole numbers and answers with one, not { $number }. For a number with decimals, write 'random_fraction() * 10'.
check-random-order = 'random' needs the smaller number first. Write 'random({ $high }, { $low })'.
check-repeat-whole-number = 'repeat' needs a whole number, not { $number }. Write 'repeat { $less }:' or 'repeat { $more }:'.
check-for-dictionary = A dictionary gives only its keys. Write 'for { $names } in items({ $value }):' for the keys with their values.
check-for-dictionary-python = A dictionary gives only its keys. Write 'for { $names } in { $value }.items():' for the keys with their values.
check-for-number = '{ $value }' is a number, not a list. Write 'for { $name } from 1 to { $value }:' to count.
check-for-number-python = '{ $value }' is a number, not a list. Write 'for { $name } in range({ $value }):' to count.
check-text-as-condition = Text in quotes is always true. Remove the quotes if it is a condition.
check-number-as-condition = { $number } is not a condition. Write a comparison, such as 'x == { $number }'.
check-action-as-condition = '{ $call }' does something and answers nothing, so this is never true. Use a question, such as one that begins with 'is_'.
check-unused-answer = '{ $call }' gives an answer, but nothing uses it. Keep it with 'answer = { $spelled }', ask it in a condition such as 'if', or show it with 'print({ $spelled })'.
check-no-result = '{ $call }' does something and returns nothing. Write it on its own line, without '='.
check-bare-value = Each side of '{ $operator }' needs its own comparison. Write '{ $operator } { $variable } { $comparison } { $value }'.
check-divide-by-zero = Nothing can be divided by 0. Write another number after '{ $operator }'.
check-swapped-operator = '{ $found }' sets '{ $name }' to the number after it. Write '{ $instead }' to change '{ $name }' by that number.
check-no-items = '{ $value }' is a number, so it has no items. Use a list or text before '['.
check-past-end = { $length ->
    [one] '{ $values }' has no item { $index }. It has only 1 item, and items are counted from 0: write '{ $values }[0]'.
   *[other] '{ $values }' has no item { $index }. It has { $length } items, counted from 0: write '{ $values }[{ $last }]' for the last one.
}
check-loop-past-end = In the last round there is no item { $index }, because items are counted from 0. Change line { $line } to 'for { $index } from 0 to len({ $values }) - 1:'.
check-loop-past-end-python = In the last round there is no item { $index }, because items are counted from 0. Change line { $line } to 'for { $index } in range(len({ $values })):'.
check-empty-list-item = '{ $values }' is empty here, so it has no item { $index }. Put items into it first, for example with 'append({ $values }, 5)'.
check-empty-list-item-python = '{ $values }' is empty here, so it has no item { $index }. Put items into it first, for example with '{ $values }.append(5)'.
check-variable-called = '{ $name }' is a number, not a function. Write '{ $name } * ({ $value })' to multiply.
check-list-called = '{ $name }' is not a function. Write '{ $name }[{ $value }]' for one of its items.
check-not-whole = "{ $text }" is not a whole number, so 'int' can't read it. Write digits only, such as "4".
check-argument-type = { $wanted ->
    [dictionary] '{ $call }' needs a dictionary first, but '{ $value }' is not a dictionary.
    [list] '{ $call }' needs a list first, but '{ $value }' is not a list.
   *[text] '{ $call }' needs text first, but '{ $value }' is not text.
}
check-length-of-number = 'len' needs text or a list, but { $value } is a number. Write 'len(str({ $value }))' to count its digits, or put a list in the brackets.
check-no-length = 'len' needs text or a list, but '{ $value }' is neither. Put one of them in the brackets.
check-list-first = The list comes first. Write '{ $call }({ $values }, { $item })'.
check-numbers-of-list = '{ $call }' calculates with the numbers of a list, but { $value } is text. Write '{ $call }([1, 2, 3])'.

## Devices

# $devices: noun phrases from check-device
check-skill-without-answer = This robot has no { $devices }: it can't answer '{ $skill }'.
check-skill-impossible = This robot has no { $devices }: it can't do '{ $skill }'.
check-skill-without-effect = This robot has no { $devices }: '{ $skill }' does nothing.
check-skill-partly = This robot has no { $devices }: that part of '{ $skill }' does nothing.
check-too-fast = This robot can't drive faster than { $most } mm/s, so { $speed } mm/s makes no difference.
check-turns-too-fast = This robot can't turn faster than { $most }°/s, so { $speed }°/s makes no difference.
check-curve-too-fast = This robot can't drive at { $adv } mm/s and turn at { $rot }°/s together: it drives the same curve at { $most } mm/s and { $turned }°/s.
check-no-device-of-name = This robot has no { $device } '{ $key }': '{ $skill }' does nothing. Use one of these: { $known }.
# $kind: a sense, or the type of a device. $key: which of several such devices, or what it can do, or empty
check-device = { $kind ->
    [Accelerometer] accelerometer
    [Animator] animations
    [Base] wheels
    [Bumper] bumper
    [Camera] { $key ->
        [emotions] camera that may recognise emotions (see: learnblock perception)
       *[other] camera
    }
    [Controller] controller
    [Display] face
    [DistanceSensors] distance sensors
    [GroundSensors] ground sensors
    [black-line] camera or ground sensors
    [blue-line] camera
    [brightness] light sensor or camera
    [ground-line] ground sensors or camera
    [heading] gyroscope or wheels
    [obstacle-back] distance sensor at the back
    [obstacle-front] distance sensor or bumper at the front
    [obstacle-left] distance sensor on the left
    [obstacle-right] distance sensor on the right
    [red-line] camera
    [shaking] accelerometer
    [tilting] accelerometer
    [text-display] LED matrix or screen
    [Gyroscope] gyroscope
    [Infrared] infrared receiver
    [JointMotor] { $key ->
        [CAMERA] camera motor
       *[other] motor
    }
    [Led] LED
    [LightSensor] light sensor
    [MP3] music player
    [Matrix] LED matrix
    [Pen] { $key ->
        [full] room for more lines: its drawing has 20,000 points
       *[other] pen (simulated robots have one)
    }
    [Screen] screen
    [RGBLed] coloured LED
    [Speaker] { $key ->
        [play] recorded sounds
        [say] voice
       *[other] speaker
    }
   *[other] { $kind } { $key }
}
# What serves a skill on the chosen robot. $devices: from check-serving-device
check-serving = On this robot: { $devices }
check-serving-device = { $kind ->
    [Accelerometer] the accelerometer
    [Base] the wheels
    [Bumper] the bumper
    [Camera] the camera
    [DistanceSensors] { $key ->
        [front] the distance sensors at the front
        [left] the distance sensors on the left
        [right] the distance sensors on the right
        [back] the distance sensors at the back
       *[other] the distance sensors
    }
    [GroundSensors] the sensors under it
    [Gyroscope] the gyroscope
    [LightSensor] the light sensor
    [Matrix] the LED matrix
    [Screen] the screen
   *[other] { $kind } { $key }
}
# $device: one that only robots of users and plugins can have
check-device-of-none = { $device } (none of LearnBlock's robots has one, but a robot of your own can)

## Which robots can run a program. $devices: noun phrases from check-device

check-robot-runs = runs
# $devices: from check-serving-device
check-robot-runs-with = runs, with { $devices }
check-robot-without = runs, but has no { $devices }
check-robot-refused = can't run it: has no { $devices }
check-robot-unknown = depends on its settings

## Structure

check-too-many-blocks = More than { $limit } blocks are nested here, which is too deep for Python. Move some of them into a function.
check-too-many-loops = More than { $limit } loops are nested here, which is too deep for Python. Move some of them into a function.
# $word: break or continue
check-outside-loop = '{ $word }' only works inside a loop. Move it into one, or remove it.
check-outside-function = 'return' only works inside a 'def' or 'when'. Move it into one, or remove it.
check-calls-itself = '{ $name }' calls itself here again and again, without end. Remove this line. Write 'forever:' above the other lines of '{ $name }' and 'end' below them.
check-calls-itself-python = '{ $name }' calls itself here again and again, without end. Remove this line. Write 'while True:' above the other lines of '{ $name }', and indent them by 4 more spaces.
# $owner: the function or event that sets the variable here
check-shared-in-recursion = '{ $name }' is shared: the call on line { $line } runs '{ $owner }' again, which changes it, and it is used after that. To give each call its own, write 'local { $name } = ...' here.
check-shared-in-recursion-python = '{ $name }' is global: the call on line { $line } runs '{ $owner }' again, which changes it, and it is used after that. To give each call its own, remove '{ $name }' from the line 'global'.
check-shared-counter = '{ $name }' is shared: the loop that calls '{ $owner }' on line { $line } counts with it, too. To give '{ $owner }' its own, write 'local { $name } = ...' here.
check-shared-counter-python = '{ $name }' is global: the loop that calls '{ $owner }' on line { $line } counts with it, too. To give '{ $owner }' its own, remove '{ $name }' from the line 'global'.
check-shared-by-events = '{ $name }' is shared: 'when { $event }' counts with it, too. To give '{ $owner }' its own, write 'local { $name } = ...' here.
check-shared-by-events-python = '{ $name }' is global: the event '{ $event }' counts with it, too. To give '{ $owner }' its own, remove '{ $name }' from the line 'global'.
# $word: break, continue or return
check-unreachable-after-jump = This is never reached because of '{ $word }' on line { $line }. Write it above that line, or remove it.
check-unreachable-after-loop = This is never reached because the loop on line { $line } never ends. Write it in the loop or above, or leave the loop with 'break'.
check-unreachable-after-call = This is never reached because '{ $name }', called on line { $line }, never ends. Write it above that line, or end the loop in '{ $name }' with 'break'.
check-unreachable-after-branches = This is never reached because no branch of the 'if' on line { $line } continues here. Write it above the 'if', or remove it.
check-sensor-outside-loop = '{ $skill }' is checked only once, when the program gets here. Put the 'if' inside 'forever:' to keep checking, or use a 'when'.
check-sensor-outside-loop-python = '{ $skill }' is checked only once, when the program gets here. Put the 'if' inside 'while True:' to keep checking, or write what it does as a function below '@robot.when(lambda: { $skill }())'.

## A program that can't run. $problem: a message from above, or from another file

check-program-error = The program has an error. { $problem }
check-program-error-in-line = The program has an error on line { $line }. { $problem }
