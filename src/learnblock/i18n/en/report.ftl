# The report at the end of a run on the command line, and the line that shows its state.

# Labels of the report's rows: at most ten characters.
report-label-ended = ended
report-label-time = time
report-label-driven = driven
report-label-goal = goal
report-label-shown = shown
report-label-no-effect = no effect
report-label-trace = trace
report-label-picture = picture

report-ended = { $how ->
    [finished] finished
    [stopped] stopped
   *[other] ended
}
report-ended-time-limit = at the time limit of { $seconds } s (change it with --for SECONDS)

# $state is reached, failed or open; $time is seconds of the robot's time.
report-goal = { $name }: { $state ->
    [reached] reached
    [failed] failed
   *[other] not reached
}
report-goal-at = { report-goal } at { NUMBER($time, minimumFractionDigits: 1) } s

report-no-device = { $robot } has no { $device }
report-emotions-off = { $robot }'s camera does not recognise emotions. See: learnblock perception

report-picture-format = { $file } must be a .png or .svg file.
report-no-picture = There is nothing to draw: the program did not use a robot.

report-demo = A simulated EBO looks for tags, drives up to each one and shows a feeling.
report-connecting = connecting
# $factor: how many times faster than real time.
report-speed = { NUMBER($factor, minimumFractionDigits: 1) } x real time
