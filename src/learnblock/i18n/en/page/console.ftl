# The console. $seconds is how long a run took.

page-console-empty = What the program prints appears here.
page-console-lines = Program output
page-console-copy = Copy
page-console-clear = Clear
page-console-open = Show the whole output
page-console-heard-here = { $robot } has no loudspeaker: you hear it on this computer.
page-console-asks = The program asks:
page-console-answer = Answer
# $number counts the runs since the program was opened; $time is the time of day.
page-console-run = Run { $number } · { $time }
# $message is a whole warning about the program.
page-console-warning = Warning: { $message }
page-console-more-warnings = { $count ->
    [one] One more warning is among the problems.
   *[other] { $count } more warnings are among the problems.
}
# $thing is such as "a wall"; $time is in seconds of the robot's time.
page-console-bumped = The robot bumped into { $thing } after { $time } s.
page-console-finished = Finished after { $seconds } s.
page-console-stopped = Stopped after { $seconds } s.
page-console-time-limit = Time limit reached after { $seconds } s.
page-console-error = Stopped by an error after { $seconds } s.
page-console-no-call = Stopped after { $seconds } s: the program did not use the robot for too long.
page-console-output-limit = Stopped after { $seconds } s: the program printed too much.
page-console-killed = Ended by the system after { $seconds } s.
