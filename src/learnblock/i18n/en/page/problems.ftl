# Problems and results. $message is the text of an error from Python.

page-problems-none = No problems. The program is ready to run.
page-problems-runs-on = This program runs on
page-problems-some = { $count ->
    [one] 1 error in the program
   *[other] { $count } errors in the program
    }
page-problems-errors = Errors
page-problems-warnings = Warnings
page-problems-last-run = In the last run
page-problems-place = { $view }, line { $line }
# $step is a block in its own words.
page-problems-block = Block “{ $step }”
page-problems-go-to = Go to the error
page-problems-add-robot = Add a robot
page-problems-stale = { $view } has an error on line { $line }. The other views show the last working program.
page-problems-stale-somewhere = { $view } has an error. The other views show the last working program.
page-problems-no-result = Run the program to see results.
page-problems-ended-finished = Finished
page-problems-ended-error = Stopped by an error
page-problems-ended-time-limit = Time is up
page-problems-ended-stopped = Stopped
page-problems-ended-no-call = Stopped: did not use the robot for too long
page-problems-ended-output-limit = Stopped: printed too much
page-problems-ended-killed = Ended by the system
page-problems-goals-reached = { $reached } of { $all ->
    [one] 1 goal
   *[other] { $all } goals
    } reached
page-problems-time = Time
page-problems-distance = Distance driven
page-problems-goals = Goals
page-problems-goal-open = not reached
page-problems-goal-reached = reached
page-problems-goal-failed = failed
page-problems-emotions = Emotions shown
page-problems-emotion-joy = joy
page-problems-emotion-sadness = sadness
page-problems-emotion-anger = anger
page-problems-emotion-fear = fear
page-problems-emotion-disgust = disgust
page-problems-emotion-surprise = surprise
page-problems-emotion-neutral = neutral
page-problems-no-effect = No effect
page-problems-missing = { $skill }: this robot has no { $device }
page-problems-emotions-off = { $skill }: emotions are not recognised on this camera. In the stage Coder, Camera recognition in the menu says why.
page-problems-trace = Trace
page-problems-hash = Hash of the run
page-problems-not-repeatable = A real robot took part, so this run can't be repeated exactly.
page-problems-hash-text = Two runs with the same hash did exactly the same.
page-problems-run-zero-division-error = You can't divide by zero. Check the number after the division sign ({ $message }).
page-problems-run-name-error = A name has no value. Give it one first, or check its spelling ({ $message }).
page-problems-run-unbound-local-error = A variable is used before it has a value. Set it first ({ $message }).
page-problems-run-type-error = These values don't go together. Check whether each is a number, text or a list ({ $message }).
page-problems-run-value-error = A value does not fit here. Check the values ({ $message }).
page-problems-run-index-error = There is no item at that position. The first position is 0 ({ $message }).
page-problems-run-key-error = There is no entry with that name ({ $message }).
page-problems-run-attribute-error = This value has nothing with that name. Check the name after the dot ({ $message }).
page-problems-run-recursion-error = A function keeps calling itself. Add a condition that ends it ({ $message }).
page-problems-open-own-at = Open the block { $name } at line { $line }
page-problems-open-own = Open the block { $name }
