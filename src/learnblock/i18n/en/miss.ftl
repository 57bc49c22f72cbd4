# By how much, and where, a run missed a goal, or what a check of a lesson asks for. $gap and $turn are
# messages whose names begin with miss-gap.

miss-gap-short = { $mm } mm short
miss-gap-past = { $mm } mm too far
miss-gap-left = { $mm } mm too far left
miss-gap-right = { $mm } mm too far right
miss-gap-away = { $mm } mm away
miss-gap-turned-left = turned { $degrees }° too far left
miss-gap-turned-right = turned { $degrees }° too far right
miss-gap-under = { $degrees }° too little
miss-gap-over = { $degrees }° too much
miss-near = At its nearest, the robot was { $gap }.
miss-stopped = The robot stopped { $gap }.
miss-stopped-facing = The robot stopped in the right place, but { $turn }.
miss-driven = The robot drove { $driven } mm: { $gap }.
miss-turned = The robot turned { $turned }°: { $gap }.
miss-goal = The goal '{ $goal }': { $gap }.
miss-corner = { $number ->
    [1] The first corner
    [2] The second corner
    [3] The third corner
    [4] The fourth corner
    [5] The fifth corner
    [6] The sixth corner
   *[other] Corner { $number }
}: { $gap }.
miss-place = Place { $number } of { $count }: { $gap }.
# $thing is the name of an object that the robot should bring.
miss-object = '{ $thing }' is not there yet.
miss-not-alone = The goal '{ $goal }': another robot is still there.
miss-facing = The goal '{ $goal }': the right place, but { $turn }.
miss-goal-stood = The goal '{ $goal }': the robot stood there for { $stood } s instead of { $asked } s.
miss-stood = The longest stop was { $stood } s instead of { $asked } s.
miss-tag-far = Tag { $tag }: { $mm } mm too far away; come within { $most } mm.
miss-tag-behind = Tag { $tag }: the robot was behind it, not in front.
miss-tag-facing = Tag { $tag }: the robot was near, but { $turn }.
miss-follow = The robot followed { $share } % of the line instead of { $asked } %.
miss-left-line = The robot left the line at { $at } s.
miss-emotion = The robot never showed '{ $emotion }'.
miss-emotion-away = The robot showed '{ $emotion }' { $mm } mm away from the place.
miss-score = The score was { $score } instead of { $asked }.
miss-collect = The robot collected { $count } of { $asked } things.
miss-gates = The robot passed { $count } of { $asked } gates in their order.
miss-life-lost = The program took a life at { $at } s.
# $thing is a thing in the world, such as bug 2.
miss-life-lost-by = '{ $thing }' took a life at { $at } s.
miss-bump = The robot bumped into something after { $mm } mm.
miss-line-never = The robot never came to the line.
miss-was-there = The robot was there at { $at } s.
