# The run of a program: how it ends, and why. Shown below the program, on the command line and in
# the report of a run.

run-finished = The program finished.
# A program that was run as "python square.py". $time is in seconds of the robot's time.
run-alone = { $program }: { NUMBER($time, minimumFractionDigits: 2) } s, { $distance } mm driven, in the world { $world }.
# $goals lists the names of goals.
run-alone-with-goals = { run-alone } Reached: { $goals }.
run-stopped = The program was stopped.
run-given-up = The program was killed, but its robot or world did not stop. If it is a real robot, switch it off.
run-stopped-by-signal = The program was stopped by the operating system.
run-time-limit =
    { $seconds ->
        [one] The time limit of { $seconds } second is up.
       *[other] The time limit of { $seconds } seconds is up.
    }
run-too-much-output = The program printed more than { $megabytes } MB and was stopped. Does one of its loops print without waiting?
run-no-robot =
    { $seconds ->
        [one] The program did not create its robot within { $seconds } second and was stopped. Does it ever reach the line with Robot()?
       *[other] The program did not create its robot within { $seconds } seconds and was stopped. Does it ever reach the line with Robot()?
    }
run-no-call =
    { $seconds ->
        [one] The program sent no command to the robot for { $seconds } second and was stopped. Is a sleep missing in one of its loops?
       *[other] The program sent no command to the robot for { $seconds } seconds and was stopped. Is a sleep missing in one of its loops?
    }
run-blocked =
    { $seconds ->
        [one] The program waited { $seconds } second for something other than the robot and was stopped. To let time pass, use a sleep of the robot.
       *[other] The program waited { $seconds } seconds for something other than the robot and was stopped. To let time pass, use a sleep of the robot.
    }
run-link-closed = The program closed its connection to the robot and was stopped.
run-lost = The run could not be made, although it was tried again: { $reason }. This is not the fault of the program.
# $status is the exit status of the process.
run-process-ended = The program's process ended unexpectedly with status { $status }.
run-processor-time =
    { $seconds ->
        [one] The program used more than { $seconds } second of processor time and was stopped.
       *[other] The program used more than { $seconds } seconds of processor time and was stopped.
    }
# $signal is a name such as SIGKILL.
run-killed = The operating system ended the program with signal { $signal }.

# Mistakes in a program.

# What Python's errors mean. $meaning is one of the messages below; $error is Python's own message.

run-means =
    { $meaning }
    Python: { $error }
# $type is Python's name of a type.
run-type = { $type ->
    [str] text
    [int] a number
    [float] a number
    [bool] True or False
    [list] a list
    [tuple] several values
    [dict] a dictionary
    [function] a function
    [method] a function
    [builtin_function_or_method] a function
    [NoneType] nothing (None)
   *[other] { $type }
}
run-means-zero-division = A number was divided by 0. Make sure that the number after '{ $operator }' is not 0.
run-means-recursion = '{ $function }' calls itself again and again and never stops. Put the call inside an 'if' that is false at some time. To repeat something, use a loop.
run-means-memory = The program used up its memory. Does a list or a text grow in a loop without end?
run-means-overflow = A number became too large. Check the calculation in this line.
run-means-empty = The list is empty, so nothing can be taken from it. Check 'len({ $list }) > 0' first.
run-means-empty-without = { $function ->
    [max] The list is empty, so it has no largest item. Check 'len({ $list }) > 0' first.
    [min] The list is empty, so it has no smallest item. Check 'len({ $list }) > 0' first.
    [median] The list is empty, so it has no median. Check 'len({ $list }) > 0' first.
    [mode] The list is empty, so it has no mode. Check 'len({ $list }) > 0' first.
   *[other] The list is empty, so it has no mean. Check 'len({ $list }) > 0' first.
}
run-means-two-items = The list has fewer than 2 items, which is too few for this. Check 'len({ $list }) > 1' first.
run-means-index = There is no item at this position. Positions go from 0 to one less than the length; '[-1]' is the last item.
run-means-picture = A picture is neither true nor false, so it can't be a condition or be compared by '==' or '!='. Ask what is in it, such as 'is_any_tag()'. In Python 'is not None' tells whether there is a picture.
run-means-key = There is no entry { $key }. Check its spelling, or add it first.
run-means-module = There is no module '{ $module }'. Check its name, or put its file next to the program.
run-means-file = There is no file { $file }. Check its name and folder.
run-means-local = '{ $name }' is used in this function before it is set. Set it above this line.
run-means-global = Inside '{ $function }', Python thinks that '{ $name }' is a new variable. Write 'global { $name }' as the first line in '{ $function }'.
run-means-name = '{ $name }' has no value yet. Set it above this line, or check its spelling.
run-means-name-near = '{ $name }' has no value. Did you mean '{ $near }'?
run-means-attribute-of-nothing = There is no value in front of '.{ $name }', only None. Store it in a variable, and check that it is not None before this line.
run-means-attribute-of-nothing-in-variable = '{ $variable }' has no value (None), so it has no '.{ $name }'. Check first: 'if { $variable } != None:'.
run-means-attribute-of-text = Text has no '{ $name }', only a list has. Join text with '+': '"a" + "b"'.
run-means-skill = The robot has no skill '{ $name }'. Check its spelling.
run-means-attribute = '{ $name }' does not exist for { $type }. Check its spelling, and the value before the dot.
run-means-attribute-near = There is no '{ $name }' after this dot. Did you mean '{ $near }'?
run-means-attribute-of-module = The module '{ $module }' has no '{ $name }'. Check its spelling.
run-means-join = Only text can be added to text, not { $type }. Write 'str(...)' around the other value.
run-means-join-number = Only text can be added to text, not a number. Write 'str(...)' around the number.
run-means-join-list = Only a list can be added to a list, not { $type }. Use 'append' to add one item.
run-means-nothing = One side of '{ $operator }' has no value (None): a sensor gave no answer, or a function has no 'return'. Store it in a variable, and check that it is not None before this line.
run-means-nothing-in-variable = '{ $variable }' has no value (None): a sensor gave no answer, or a function has no 'return'. Check first: 'if { $variable } != None:'.
run-means-operands = '{ $operator }' does not work with { $type } and { $other_type }. Use a number on each side.
run-means-calculation = '{ $operator }' can't calculate with text. Write 'int(...)' around the text, or 'float(...)' if it has a decimal point.
run-means-comparison = '{ $operator }' can't compare { $type } with { $other_type }. Compare two numbers or two texts.
run-means-comparison-with-text = '{ $operator }' can't compare text with a number. Write 'int(...)' around the text, or 'float(...)' if it has a decimal point.
run-means-multiply = A text or a list can only be multiplied by a whole number. Write 'int(...)' around the other value.
run-means-multiply-by-other = Text or a list can't be multiplied by { $type }. One side of '*' must be a whole number, such as '"a" * 3'.
run-means-whole-number = A whole number is needed here, not { $type }. Write 'int(...)' around it.
run-means-number = A number is needed here, not { $type }. Write 'float(...)' around it.
run-means-call = This is { $type }, not a function. Remove the brackets after it, or rename the variable.
run-means-items = This is { $type }, so it has no items. Use a list or a text before '['.
run-means-iteration = A loop needs a list or a text, not { $type }. Write 'range(...)' around a number.
run-means-length = 'len' needs a list or a text, not { $type }. Put one of them in the brackets.
run-means-length-of-number = 'len' needs a list or a text, not a number. Write 'len(str(...))' to count its digits.
run-means-position = A position is a whole number, counted from 0. Write 'int(...)' around it.
run-means-position-in-quotes = The position in '[...]' is text here. Write it without quotes, or 'int(...)' around it.
run-means-item-assignment = A part of { $type } can't be set. Make a new value instead.
run-means-letter-assignment = A letter of a text can't be changed. Make a new text, such as 'name = "a" + "na"'.
run-means-missing-argument = '{ $function }' needs more values: { $names }. Write them in the brackets.
run-means-too-many-arguments = { $excess ->
    [one] '{ $function }' got 1 value too many. Remove 1 from the brackets.
   *[other] '{ $function }' got { $excess } values too many. Remove { $excess } from the brackets.
}
run-means-unknown-argument = '{ $function }' has no argument '{ $name }'. Check its spelling.
run-means-unknown-argument-of = '{ $function }' has no argument '{ $name }'. Its arguments are: { $known }.
run-means-no-arguments = '{ $function }' has no arguments. Write '{ $function }()', with nothing in its brackets.
run-means-int = { $text } is not a whole number, so 'int' can't read it. Check the text, or what was typed in.
run-means-int-of-decimal = { $text } is not a whole number, so 'int' can't read it. Write 'float(...)' for numbers with a decimal point.
run-means-float = { $text } is not a number, so 'float' can't read it. Check the text, and write a point, not a comma.
run-means-domain = This can't be calculated with the number in the brackets. Check it, with 'print' above this line.
run-means-root = A negative number has no square root. Make sure that the number in the brackets is 0 or more.
run-means-logarithm = 0 and negative numbers have no logarithm. Make sure that the number in the brackets is more than 0.
run-means-range = The first number is larger than the last. Swap them.
run-means-not-in-list = The list does not contain this value. Check with 'in' first.
run-means-not-in-this-list = The list does not contain this value. Check first: 'if { $value } in { $list }:'.
run-means-separator = 'split' needs the text at which to cut, such as ",". Write 'list(...)' around a text to get its letters.
run-means-unpack = There are not as many variables as values to put into them.
run-means-unpack-few = { $after ->
    [one] There are { $before } variables, but only 1 value to put into them. Write one value for each variable.
   *[other] There are { $before } variables, but only { $after } values to put into them. Write one value for each variable.
}
run-means-unpack-many = There are only { $before } variables, but more values to put into them. Write one variable for each value.
run-means-unpack-single = This is { $type }, which can't be put into several variables. Use a list with a value for each.

# $type and $failed are Python's names of errors.
run-error-without-text = The error { $type } has no readable message: its __str__ raised { $failed }.
run-second-robot = A program can have only one robot at a time. Remove the second Robot() from it.
run-inline-thread = A thread of the program used the robot. Here only the program's own steps may do that: call the robot's functions outside the thread.
run-input-ended = The program asked for input, but there is none left.
# $event is Python's name of what was attempted, such as os.fork.
run-no-processes = A robot program is not allowed to start or stop other programs ({ $event }).
# $event is Python's name of what was attempted, such as socket.connect.
run-no-network = A robot program is not allowed to use the network ({ $event }). Run it with learnblock run --allow-network if it needs to.
# $file is the file's name.
run-no-access = No access to { $file }. A robot program can read the files of its own project, and write only to its temporary folder.
# $reason is the operating system's own message.
run-not-contained = The program was not started, because it could not be contained: { $reason }. Run learnblock doctor.
# $megabytes is a number.
run-too-much-disk = The program wrote more than { $megabytes } MB to its temporary folder.
# $limit is a number.
run-too-many-files = The program made more than { $limit } files.
# $limit is a number.
run-too-many-threads = The program started more than { $limit } threads.
run-variable-uses-robot = The __str__ of a variable cannot use the robot or print.
# $reason is Python's own message.
run-value-not-sendable = A value cannot be sent to the robot: { $reason }.
# $size and $limit are numbers of bytes.
run-value-too-large = A value of { $size } bytes is too large to be sent to the robot: the limit is { $limit } bytes.
run-not-a-trace = This is not the trace of a run on simulated robots.
run-no-program-file = LEARNBLOCK_TRACE can only record a program that is run from a file, and this one is not.

# Failures of the robot. $reason is a sentence or another program's error message.

run-robot-not-created = The robot could not be created. { $reason }
run-driver-refused = The computer refused this ({ $reason }). If the robot's driver needs it, its author adds it to the driver's 'rights'.
run-robot-not-stopped = The robot could not be stopped. { $reason }
# $function is a function of a device, such as move or read.
run-call-failed = The robot did not carry out '{ $function }'. { $reason }
run-robot-stopped = The robot has been stopped and accepts no more commands.
# $device is a type of device; $known lists the types there are.
run-unknown-device = The robot has a device of type { $device }, which programs cannot use. Known types: { $known }.
run-not-a-message = A message between program and robot makes no sense: { $reason }. Use the robot only through its skills and devices.
run-no-debugger = This run cannot be paused because it was started without a debugger.

# A program's file.

run-unknown-file-type = LearnBlock can run .bt files (Block-Text), .py files (Python) and .learnblock files (projects) only.
# $byte is a number such as 0xe9.
run-not-utf-8 = Byte { $byte } is not UTF-8. Save the file as UTF-8.
