# Problems of blocks, shown at the block.

workspace-missing-value = This block has an empty slot. Plug a value into it, such as a number, a text or a variable.
workspace-missing-number = This block has an empty slot for a number. Plug one in, such as a number from 'Maths' or a variable.
workspace-missing-text = This block has an empty slot for a text. Plug one in, such as a text from 'Maths' or a variable.
workspace-missing-dictionary = A dictionary is missing in this block. Plug in the variable that holds it.
workspace-missing-list = This block has an empty slot for a list. Plug one in, such as 'create list with' or a variable.
workspace-missing-text-or-list = 'length of' has an empty slot. Plug in text from 'Maths', 'create list with' from 'Variables', or a variable.
workspace-missing-variable-of-list = This block has no list to change. Plug in a variable that holds a list.
workspace-missing-condition = A condition is missing in this block, and an empty slot counts as 'false'. Plug in a comparison from 'Maths' or a question for the robot.
workspace-wait-without-condition = A condition is missing in this block, so it waits forever. Plug in a comparison from 'Maths' or a question for the robot.
workspace-missing-side = One side of this block is empty, and an empty slot counts as 'false'. Plug in a comparison from 'Maths' or a question for the robot.
workspace-empty-block = There is nothing inside this block, so it does nothing. Put blocks into it, or remove it.
workspace-missing-variable = This block is missing a variable. Choose one.
workspace-missing-python = Write a Python expression here.
workspace-bad-number = This is not a number. Write one, such as 40.
# $field: the name of the field
workspace-unknown-choice = This block has an unknown option in '{ $field }'. Choose another.
# $nearest: a name that is allowed
workspace-bad-name = '{ $name }' can't be a name here. Use letters, digits and _, as in '{ $nearest }', but not a reserved word.
workspace-duplicate-argument = The argument '{ $name }' is given twice. Rename or remove one.
workspace-duplicate-parameter = Two parameters of this function have the same name. Rename one.
workspace-unknown-skill = There is no skill '{ $name }' here. Remove this block.
# $type: the name of the type in Blockly
workspace-unknown-block = A program can't have a block of type '{ $type }' here. Remove it.
workspace-misplaced-block = This block belongs under 'at the start', outside of all other blocks.
workspace-without-robot = This program has no robot. Delete the block 'without robot'.
workspace-robot-not-first = 'robot' must come before everything else. Move this block to the beginning.
workspace-second-main = A program can have only one 'when Run is pressed'. Move the blocks under this one to the other one, and delete this one.
# $words: the first line of a part of a statement in Python
workspace-not-a-part = '{ $words }' can't be a further part of this block. Begin it with 'except', 'else', 'finally' or 'case'.
workspace-not-a-beginning = A block can't begin with '{ $words }'. Put this part into the block that it belongs to.
workspace-empty-comparison = This comparison compares nothing. Remove it.
workspace-python-lines = A Python value must be on one line. Use the block for Python lines instead.
workspace-unused-value = This value is not used. Put it into a block 'set ... to', or remove it.
workspace-list-without-name = Only a list in a variable can be changed. Choose one.
workspace-import-name = Write only the name of the library, such as 'dance', without a folder or '.py'.
workspace-too-many-values = Too many values are nested here. Store some of them in a variable.
workspace-too-deep = Too many blocks are nested here. Move some of them into a function.

## Blocks that do not run

# $count: the number of blocks in the stack
workspace-loose-blocks = { $count ->
    [one] This block does not run, because it is not connected to the program. Drag it under 'when Run is pressed' or another block of the program, or delete it.
   *[other] These { $count } blocks do not run, because they are not connected to the program. Drag them under 'when Run is pressed' or another block of the program, or delete them.
}
workspace-no-program = { $count ->
    [one] This block does not run, because the program has no 'when Run is pressed'. Take it from 'Events', and drag this block under it.
   *[other] These { $count } blocks do not run, because the program has no 'when Run is pressed'. Take it from 'Events', and drag these blocks under it.
}
workspace-loose-value = This value is not plugged into any block, so it does nothing. Drag it into a slot of another block, or delete it.
workspace-only-functions = '{ $name }' is never called, so the program does nothing. Take 'when Run is pressed' from 'Events', and put '{ $name }' from 'My blocks' under it.

## Mistakes in a program that check.ftl words for text: the same, in the words of blocks

workspace-unknown-name = '{ $name }' has no value. Put a block 'set { $name } to' from 'Variables' above.
workspace-unknown-name-near = '{ $name }' has no value. Did you mean '{ $near }'? Choose it in this block.
workspace-read-before-set = '{ $name }' has no value yet when the program gets here. Move the block 'set { $name } to' up to the beginning of the program.
workspace-defined-below = The Python of this program uses '{ $name }' here, above its definition. Move 'def { $name }' up in the Python view.
workspace-unknown-function = There is no function '{ $name }'. Make it with a 'define' block from 'My blocks', or remove this block.
workspace-no-such-skill = The robot has no skill '{ $name }'. Remove this block, and take another one from the palette.
workspace-unknown-when = There is no event '{ $name }'. Make it with 'New event…' in 'Events', or choose another one in this block.
workspace-unknown-when-near = There is no event '{ $name }'. Did you mean '{ $near }'? Choose it in this block.
workspace-never-started = Nothing starts the event '{ $name }', so it never runs. Put a block 'start { $name }' from 'Events' into the program, or add a condition to this block with its '+'.
workspace-events-never-run = This loop never ends, so events such as '{ $name }' never run. Put what the loop repeats into an event with 'true' as its condition, or put an 'if' with 'leave the loop' into the loop.
workspace-events-held-up = Once this loop has begun, it never ends, so events such as '{ $name }' don't run any more. Put an 'if' with 'leave the loop' into the loop.
workspace-events-held-up-by-event = Once this loop has begun, it never ends, so other events such as '{ $name }' don't run any more. Take its blocks out of the loop: the blocks of an event are repeated anyway while it is active.
# $word: def or when
workspace-defined-twice = { $word ->
    [def] There are two functions '{ $name }'.
   *[other] There are two events '{ $name }'.
} Rename this one, or move its blocks to the other one and delete this one.
workspace-follows-condition = The event '{ $name }' follows its condition, so this block lasts one round at most. Put into the condition what should start or stop it.
workspace-value-of-event = '{ $name }' is the { $value ->
    [time] time
   *[active] state
} of the event '{ $event }', so nothing else can have this name. Choose another name in this block.
workspace-not-imported = This block belongs to the library '{ $library }'. Put a block 'import { $library }' from 'Control' under 'at the start'.
# $names: of the parameters without a value
workspace-missing-argument = This block needs a value for: { $names }. Remove it, and take '{ $call }' from the palette again: that one has all its slots.
workspace-too-many-arguments = { $most ->
    [0] '{ $call }' takes no values.
    [one] '{ $call }' takes only 1 value ({ $parameters }).
   *[other] '{ $call }' takes only { $most } values ({ $parameters }).
} Remove the whole block, and take '{ $call }' from the palette again: it has the right slots.
workspace-text-for-number = This is text, but a number is needed. Put a number from 'Maths' here.
workspace-number-as-text = "{ $number }" is text here, but a number is needed. Replace this block with a number from 'Maths', and write { $number } in it.
workspace-outside-range = This value is { $value }. Choose one between { $least } and { $most }.
workspace-negative-wait = The robot can't wait { $seconds } seconds. Write 0 or more.
# $choices: as in a program
workspace-no-such-choice = { $value } can't be chosen here. The choices are: { $choices }.
workspace-not-a-colour = { $value } is not a colour. Choose one in this block.
workspace-whole-number = 'count with' counts in whole numbers, not { $number }. Write a whole number.
workspace-step-zero = With 'by 0' the loop would never end. Write another number after 'by'.
workspace-counts-up = This loop never runs, because it counts up from { $start } to { $stop }. Write -1 after 'by' to count down.
workspace-never-repeats = Repeating { $count } times means that the blocks inside never run. Write a number above 0.
workspace-idle-wait = Nothing changes this condition while the program waits here, so it waits forever or not at all. Use a question for the robot in it.
workspace-unchanged-in-wait = Only other blocks could change '{ $name }', and none of them runs while the program waits here. So it waits forever or not at all. Use a question for the robot in it.
workspace-unchanged-in-loop = Nothing in this loop changes '{ $name }', and no other block runs meanwhile, so the loop never ends once it has begun. Change '{ $name }' in it, or put 'leave the loop' where it should end.
workspace-told-stays = This question only repeats what the robot was last told to do, and nothing here tells it anything else. So the program stays here forever or not at all. Use a question for a sensor.
workspace-state-in-wait = Events don't run while the program waits here, so '{ $event }' can't start or stop: it waits forever or not at all. Move the blocks below into 'when { $event }', or use a question for the robot.
workspace-state-in-loop = Events don't run during this loop, so '{ $event }' can't start or stop and the loop never ends once it has begun. Move its blocks into 'when { $event }', or use a question for the robot.
workspace-time-stays = The time of '{ $event }' stays 0 here, because nothing has started it before. Put 'start { $event }' above, or wait a number of seconds.
workspace-growing-list = This loop adds to '{ $name }' while it goes through it, so it never ends. Go through a copy of the list.
workspace-idle-loop = Nothing is inside this loop, so it never ends. Put the blocks that it should repeat into it, or remove it.
workspace-speed-as-angle = This is a speed: the robot would keep turning at { $speed }°/s. { $side ->
    [left] To turn left by { $speed } degrees, choose 'left' in the block 'turn ... by ...°'.
   *[other] To turn by { $speed } degrees, use the block 'turn ... by ...°'.
}
workspace-convert-to-number = This is text, but a number is needed. Put the block 'int' from 'Maths' around it, which makes it a number.
workspace-answer-for-number = What is typed in is always text, even 5, but a number is needed here. Put the block 'int' from 'Maths' around this.
workspace-answer-changed = '{ $name }' holds what was typed in, which is always text, even 5. Use 'set { $name } to' with 'int' from 'Maths' around what was typed in.
workspace-dictionary-for-number = This is a dictionary, but a number is needed. Put the block 'in dictionary get' from 'Variables' around it.
workspace-list-for-number = This is a list, but a number is needed. Use 'in list ... get #' for one of its items, or 'length of' for how many it has.
workspace-join-text = Only text can be added to text. Put the block 'str' from 'Maths' around this, which makes it text.
workspace-append = Only a list can be added to a list. To add one item, replace the whole block 'set ... to' with 'in list ... insert at last' from 'Variables'.
# $advice: one of the messages about text for a number
workspace-rounded = Computers round decimals: 0.1 + 0.2 is 0.30000000000000004. So these two may differ by very little. Round what is calculated, or compare with '≥' or '≤'.
workspace-never-equal = Text never equals a number. { $advice }
workspace-decimals = A whole number is needed here, but this one has decimals, as in 5.0. Put a 'round' block around it.
workspace-repeat-whole-number = 'repeat' needs a whole number, not { $number }. Write { $less } or { $more }.
workspace-for-dictionary = A dictionary gives only its keys. Put the block 'entries of' around it for the keys with their values.
workspace-for-number = This is a number, not a list. To count, use 'count with { $name } from 1 to { $value }' instead of 'for each item'.
workspace-text-as-condition = Text is not a condition: it counts as true. Put a comparison from 'Maths' or a question for the robot here.
workspace-number-as-condition = The number { $number } is not a condition. Put a comparison from 'Maths' or a question for the robot here.
workspace-action-as-condition = This block does something and answers nothing. Put a comparison from 'Maths' or a question for the robot here.
workspace-unused-answer = This block gives an answer, but nothing uses it. Put it into a variable, a condition or 'print'.
workspace-no-result = This function returns nothing, so there is no value to use. Give it a 'return' block, or put it into the program without this block around it.
workspace-bare-value = Each side of '{ $operator }' needs its own comparison. Replace this with '{ $variable } { $comparison } { $value }' from 'Maths'.
workspace-divide-by-zero = Nothing can be divided by 0. Write another number here.
workspace-length-of-number = 'length of' needs text or a list, but this is a number. Plug in text or a list instead.
workspace-numbers-of-list = This is text, but the block around it needs a list of numbers. Replace it with 'create list with' from 'Variables', and plug numbers into that.
workspace-past-end = { $length ->
    [one] There is no item # { $index }. The list has only 1 item, which is # 0: items are counted from 0.
   *[other] There is no item # { $index }. The list has { $length } items, and they are counted from 0: the last one is # { $last }.
}
workspace-loop-past-end = There is no item # { $index } in the last round: items are counted from 0. Count from 0 to 'length of { $values }' - 1.
workspace-empty-list-item = '{ $values }' is empty, so it has no item # { $index }. Before this block, put items into it with 'in list ... insert at last' from 'Variables'.
workspace-calls-itself = '{ $name }' calls itself here again and again, without end. Remove this block, and put 'repeat forever' around the other blocks of '{ $name }'.
# $owner: the function or event of this block
workspace-shared-in-recursion = '{ $name }' is shared: '{ $owner }' runs itself again, which changes it, and it is used after that. To give each call its own, use 'set local { $name }' in place of this block.
workspace-shared-counter = '{ $name }' is shared: a loop that runs '{ $owner }' counts with it, too. To give '{ $owner }' its own, use 'set local { $name }' in place of this block.
workspace-shared-by-events = '{ $name }' is shared: the event '{ $event }' counts with it, too. To give '{ $owner }' its own, use 'set local { $name }' in place of this block.
# $devices: noun phrases from check-device
workspace-skill-without-answer = This robot has no { $devices }, so it can't answer this question. Remove the block, or choose another robot.
workspace-skill-impossible = This robot has no { $devices }, so it can't do this. Remove the block, or choose another robot.
workspace-skill-without-effect = This robot has no { $devices }, so this block does nothing. Remove it, or choose another robot.
workspace-no-device-of-name = This robot has no { $device } '{ $key }', so this block does nothing. Choose one of: { $known }.
workspace-outside-loop = This block only works inside a loop. Move it into a 'repeat', 'count with' or 'for each item' block, or remove it.
workspace-outside-function = This block only works inside a function or an event. Move it into a 'define' or 'when' block, or remove it.
workspace-unreachable-after-jump = This block never runs: the block above it leaves { $word ->
    [return] the function
   *[other] this round of the loop
} first. Move it above that block, or remove it.
workspace-unreachable-after-loop = This block never runs: the loop above it never ends. Move it into the loop or above it, or end the loop with 'leave the loop'.
workspace-unreachable-after-call = This is never reached because '{ $name }' above it never ends. Move it above that block, or put 'leave the loop' into the loop of '{ $name }'.
workspace-unreachable-after-branches = This block never runs: every branch of the 'if' above leaves before it. Move it above the 'if', or remove it.
workspace-sensor-outside-loop = The robot is asked only once, when the program gets here. To keep asking, put this block into 'repeat forever', or use an event from 'Events'.
