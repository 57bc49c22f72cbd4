# The report at the end of a run on the command line, and the line that shows its state.

# Labels of the report's rows: at most ten characters.
report-label-ended = ended
report-label-time = time
report-label-driven = driven
report-label-goal = goal
report-label-pose = at
report-label-shown = shown
report-label-no-effect = no effect
report-label-trace = trace
report-label-picture = picture
report-label-page = page

report-ended-finished = finished
report-ended-stopped = stopped
report-ended-otherwise = ended
report-ended-time-limit = at the time limit of { $seconds } s (change it with --for SECONDS)

# A number with one decimal.
report-decimal = { $whole }.{ $tenths }

# $time is seconds of the robot's time.
report-goal-reached = { $name }: reached at { $time } s
report-goal-failed = { $name }: failed at { $time } s
report-goal-open = { $name }: not reached

report-no-device = { $robot } has no { $device }
report-emotions-off = { $robot }'s camera does not recognise emotions. See: learnblock perception

report-picture-format = { $file } must be a .png or .svg file.
report-no-picture = There is nothing to draw: the program did not use a robot.

report-demo = A simulated EBO looks for tags, drives up to each one and shows a feeling.
report-connecting = connecting
# $factor: how many times faster than real time.
report-speed = { $factor } x real time

# Runs with several robots.
report-team-too-many = { $count } robots are too many for one run: at most { $limit } can take part.
report-team-running = { $count } of { $all } running
report-team-not-deterministic = differs with each run, since a real robot took part

# Runs in many variants of a world. $reached of $all goals were reached; $time is in seconds.
report-variant = variant { $variant }: { $reached } of { $all } goals, { $time } s
report-replay-true = The poses and goals are true: { $count } were repeated.
report-replay-false = The trace is not true: it differs from the repeated run after { $seconds } s.
report-variants-reached = { $reached } of { $all } variants: every goal reached.
report-variants-alone = With --variants, name one program for one robot, and leave out --variant, --trace and --picture.

# Keys of the keyboard. $keys: their names; the braces belong to JSON.
report-listens = This program listens to the keyboard: { $keys }. Ctrl-C ends it.
# $programs: the name of each robot and its keys, such as "left ↑ ↓; right w s".
report-team-listens = The programs listen to the keyboard: { $programs }. Ctrl-C ends them all.
report-why-alone = With --why, leave out --variants.
report-page-alone = With --page, leave out --variants.
report-name-without-page = With --name, add --page FILE: that page says who made it.
report-why-not-a-folder = The logs of several robots need a folder, and { $folder } cannot be one.
report-why-not-whole = The log for questions ends too early: { $reason }
report-keys-line = Write a line such as {"{"}"t": 1.5, "keys": ["up"]{"}"}.
