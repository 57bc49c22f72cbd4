# The run of a program: how it ends, and why. Shown below the program, on the command line and in
# the report of a run.

run-finished = The program finished.
run-stopped = The program was stopped.
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
run-link-closed = The program closed its connection to the robot and was stopped.
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

# $error is Python's own message, such as: NameError: name 'robt' is not defined
run-did-you-mean = { $error }. Did you mean '{ $suggestion }'?
# $type and $failed are Python's names of errors.
run-error-without-text = The error { $type } has no readable message: its __str__ raised { $failed }.
run-second-robot = A program can have only one robot at a time. Remove the second Robot() from it.
run-input-ended = The program asked for input, but there is none left.
# $event is Python's name of what was attempted, such as os.fork.
run-no-processes = A robot program is not allowed to start or stop other programs ({ $event }).
run-variable-uses-robot = The __str__ of a variable cannot use the robot or print.
# $reason is Python's own message.
run-value-not-sendable = A value cannot be sent to the robot: { $reason }.
# $size and $limit are numbers of bytes.
run-value-too-large = A value of { $size } bytes is too large to be sent to the robot: the limit is { $limit } bytes.
run-no-program-file = LEARNBLOCK_TRACE records a program that runs from a file, but no file is running.

# Failures of the robot. $reason is a sentence or another program's error message.

run-robot-not-created = The robot could not be created. { $reason }
run-robot-not-stopped = The robot could not be stopped. { $reason }
# $function is a function of a device, such as move or read.
run-call-failed = The robot did not carry out '{ $function }'. { $reason }
run-robot-stopped = The robot has been stopped and accepts no more commands.
# $device is a type of device; $known lists the types there are.
run-unknown-device = The robot has a device of type { $device }, which programs cannot use. Known types: { $known }.
run-message-too-long = A message of { $size } bytes on the link between robot and program is too long.
run-not-a-message = A message on the link between robot and program is damaged: { $reason }.
run-no-debugger = This run cannot be paused because it was started without a debugger.

# A program's file.

run-unknown-file-type = LearnBlock can run .bt files (Block-Text) and .py files (Python) only.
# $byte is a number such as 0xe9.
run-not-utf-8 = Byte { $byte } is not UTF-8. Save the file as UTF-8.
