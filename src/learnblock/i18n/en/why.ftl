# Answers to questions about a run. $line is a line's number, $code its text, $time seconds.
# On a page that shows only blocks $line and $inner are "block", and $code and $innerCode are the words of the blocks.
why-line = { $line ->
    [block] the block { $code }
   *[other] line { $line }
}
why-first-line = { $line ->
    [block] The block { $code }
   *[other] Line { $line }
}
why-line-code = { $line ->
    [block] the block { $code }
   *[other] line { $line }, { $code }
}
why-line-does = { $line ->
    [block] the block { $code }
   *[other] line { $line }, { $code },
}
why-first-line-does = { $line ->
    [block] The block { $code }
   *[other] Line { $line }, { $code },
}
why-line-says = { $line ->
    [block] the block { $code } does that
   *[other] line { $line } says { $code }
}
why-inner = { $inner ->
    [block] the block { $innerCode }
   *[other] line { $inner }
}
why-first-inner = { $inner ->
    [block] The block { $innerCode }
   *[other] Line { $inner }
}

why-not-understood = LearnBlock does not understand "{ $question }". Ask, for example: { $first } { $second } { $third }

why-answer-true = yes
why-answer-false = no
why-value-none = nothing
why-at = { " " }at { $time } s
why-between = { " " }between { $since } and { $time } s
why-since = { " " }after { $time } s

# Movements, after "was told to".
why-move-stand = stand still
why-move-forward = drive straight ahead
why-move-back = drive backwards
why-move-spin-left = turn left on the spot
why-move-spin-right = turn right on the spot
why-move-curve-left = drive in a curve to the left
why-move-turn = turn
why-move-curve-right = drive in a curve to the right

# Questions.
why-ask-movement = Why did the robot { $subject }{ $time }?
why-ask-not-movement = Why did the robot not { $subject }{ $time }?
why-ask-skill = Why did it "{ $subject }"{ $time }?
why-ask-not-skill = Why did it not "{ $subject }"{ $time }?
why-ask-print = Why was the text of line { $subject } printed{ $time }?
why-ask-not-print = Why was the text of line { $subject } not printed{ $time }?
why-ask-printed = Why was "{ $subject }" printed{ $time }?
why-ask-when = Why was "when { $subject }" active{ $time }?
why-ask-not-when = Why was "when { $subject }" not active{ $time }?
why-ask-line = Why did line { $subject } run{ $time }?
why-ask-not-line = Why did line { $subject } not run{ $time }?
why-ask-value = Why does { $subject } have this value{ $time }?
why-ask-goal = Why was the goal "{ $subject }" not reached?
why-ask-reached = Why was the goal "{ $subject }" reached?
why-ask-emotion = Why did the robot show { $subject }{ $time }?
why-emotion = { $emotion ->
    [joy] joy
    [sadness] sadness
    [anger] anger
    [fear] fear
    [disgust] disgust
    [surprise] surprise
    [neutral] no emotion
   *[other] { $emotion }
}
why-ask-end = Why did the program end?
why-ask-not-end = Why did the program not end{ $time }?
why-ask-nothing = Why did nothing happen{ $time }?
why-ask-long = Why did the robot { $subject } for so long{ $time }?
why-ask-speed = Why was the robot so { $subject ->
    [fast] fast
   *[slow] slow
}{ $time }?
why-ask-lost = Why did the robot leave the line{ $time }?
why-ask-fall = Why did the robot fall{ $time }?
why-ask-bump = Why did the robot bump into { $subject }{ $time }?
why-ask-print-text = Why was "{ $subject }" printed{ $time }?
why-ask-not-print-text = Why was "{ $subject }" not printed{ $time }?
why-ask-print-any = Why was a text printed{ $time }?
why-ask-not-print-any = Why was no text printed{ $time }?
why-ask-goal-any = Why was the goal not reached?
why-ask-reached-any = Why was the goal reached?
why-ask-bump-any = Why did the robot bump into something{ $time }?
why-ask-score = Why is the score { $subject }{ $time }?
why-ask-lives = Why did the lives change{ $time }?
why-ask-game = { $subject ->
    [won] Why was the game won{ $time }?
   *[lost] Why is the game over{ $time }?
}
why-ask-now = What was the robot doing{ $time }?

# Facts behind a condition, separated by commas.
why-facts = : { $facts }
why-name-was = { $name } was { $value }
why-when-state = "when { $name }" was { $active ->
    [true] active
   *[other] not active
}
why-when-time = "when { $name }" had been active for { $seconds } s
why-own-gave = { $name } gave { $value }
why-answered = "{ $skill }" answered { $value }
why-never-answers = this robot has no { $device }, so "{ $skill }" never finds anything
why-thing = { " " }({ $thing })
# Filled in when the thing is known.
why-thing-at = { "" }
why-side = { $side ->
    [front] front
    [left] left
    [right] right
    [back] back
    [central] middle
    [center] middle
   *[other] { $side }
}
why-measured = the { $side } sensor measured { $mm } mm{ $thing }
why-measured-limit = the { $side } sensor measured { $mm } mm{ $thing }, { $less ->
    [true] less
   *[other] not less
} than { $limit } mm
why-saw-nothing = the { $side } sensor saw nothing
why-ground-side = { $side ->
    [left] on the left
    [right] on the right
    [front] at the front
    [back] at the back
   *[other] in the middle
}
why-ground = { $dark ->
    [true] dark
   *[other] bright
} { $side } ({ $value })
why-ground-saw = the floor was { $sensors }
why-colour = { $colour ->
    [black] black
    [red] red
    [blue] blue
   *[other] { $colour }
}
why-saw-line = the camera saw { $colour } points: { $left } on the left, { $center } in the middle, { $right } on the right
why-saw-no-line = the camera saw nothing { $colour }
why-saw-tags = the camera saw tag { $tags }
why-saw-no-tag = the camera saw no tag
why-time-was = the program had run for { $time } s, not more than { $limit } s
why-time-was-over = the program had run for { $time } s, more than { $limit } s
why-closest = {" "}The closest was { $mm } mm, at { $time } s.

# What happened.
why-moved = At { $time } s the robot was told to { $motion }: { why-line-says }.
why-moved-alone = At { $time } s the robot was told to { $motion }.
why-after = Before that, { why-line-does } lasted from { $since } to { $time } s.
why-ran = { why-first-line-does } ran at { $time } s.
why-when-ran = "when { $name }" in { why-line } was active at { $time } s.
why-condition-was = { $true ->
    [true] It came there because { why-line-does } was true at { $time } s{ $facts }.
   *[other] It came there because { why-line-does } was not true at { $time } s{ $facts }.
}
why-loop-over = The loop in { why-line-does } was over at { $time } s{ $facts }.
why-when-was = "when { $name }" was { $active ->
    [true] active, because its condition in { why-line } was true
   *[other] not active, because its condition in { why-line } was not true
} at { $time } s{ $facts }.
why-switched = { why-first-line-does } { $on ->
    [true] started
   *[other] stopped
} "when { $name }" at { $time } s.
why-called = { why-first-line-does } called { $name } at { $time } s.
why-given = { $name } was { $value }: { why-line-does } gave it to { $function } at { $time } s.
why-set = { $name } was { $value }: { why-line-does } set it at { $time } s.
why-set-through = { why-first-line-does } changed { $other } at { $time } s, and { $other } and { $name } are one and the same list, now { $value }.
why-returned = { $name } gave back { $value } at { $time } s: { why-line-says }.
why-no-return = { $name } in { why-line } gave nothing back: no "return" in it was reached.

# What did not happen.
why-no-such-movement = No line of your program tells the robot to { $motion }.
why-no-such-skill = No line of your program says "{ $skill }".
why-no-such-line = { why-first-line } has nothing that could run.
why-it-did = It did: { why-line-does } { $lasted ->
    [over] ran from { $time } to { $until } s.
    [still] began at { $time } s.
   *[no] ran at { $time } s.
}
why-overridden-soon = But right after it, { why-line-does } told the robot: { $motion }.
why-overridden-later = But { $seconds } s later, { why-line-does } told the robot: { $motion }.
why-no-effect = { why-first-line-does } ran at { $time } s but had no effect: this robot has no { $device }.
why-needs = { why-first-inner } only runs if { why-line-does } is { $needed ->
    [true] true; at { $time } s it was not
   *[other] not true; at { $time } s it was
}{ $facts }.{ $closest }
why-hidden = { why-first-inner } was not even asked: { why-line-does } came first and was true at { $time } s{ $facts }.
why-nothing-to-repeat = { why-first-inner } is in the loop of { why-line-does } which had nothing to go through.
why-never-called = { why-first-inner } is in { $name }, and no line calls { $name }.
why-not-called = { $name } is only called in { why-line-does } which did not run.
why-when-never = "when { $name }" was not active: its condition in { why-line } was not true at { $time } s{ $facts }.{ $closest }
why-never-activated = "when { $name }" in { why-line } was not active: no line starts it.
why-activates-other = { why-first-line-does } starts "when { $name }", not "when { $inner }".
why-activate-not-run = Only { why-line-does } starts "when { $name }", and it had not run.
why-left = { why-first-line-does } left before { why-inner } was reached, at { $time } s.
why-in-loop = { $endless ->
    [true] { why-first-inner } comes after the loop in { why-line-does } which never ends by itself.
   *[other] { why-first-inner } comes after the loop in { why-line-does } which was still going on at { $time } s{ $facts }.{ $closest }
}
why-break-inner = { why-first-line-does } left only the loop in { why-inner }, at { $time } s.
why-asked-once = Line { $line }, { $code }, was asked only once, at { $time } s: no loop is around it.
why-busy = From { $since } to { $until } s the program was busy with { why-line-does } and did nothing else.
why-waiting = The program was still waiting in { why-line-does } at { $time } s{ $facts }.{ $closest }
why-failed = The program had ended with an error in { why-line-code }: { $message }
why-finished = The program was over at { $time } s: it had reached its end.
why-time-limit = The run was stopped at { $time } s, at its time limit.
why-stopped = The run was stopped at { $time } s.
why-not-set = No line had set { $name } yet.
why-bumped = The robot bumped into { $name } at { $time } s.
why-no-bump = The robot did not bump into anything.
why-goal = The goal "{ $name }" { $state ->
    [reached] was reached at
    [failed] failed at
   *[other] was not reached by
} { $time } s.
why-score-changed = At { $time } s the program changed the score to { $value }.
why-score-changed-by = At { $time } s "{ $thing }" changed the score to { $value }.
why-lives-changed = At { $time } s the program changed the lives to { $value }.
why-lives-changed-by = At { $time } s "{ $thing }" changed the lives to { $value }.
# $reason is a thing, a goal, or one of these words.
why-game-ended = The game was { $end ->
    [won] won
   *[lost] over
} at { $time } s: { $reason ->
    [program] the program ended it
    [lives] no lives were left
    [time] the time was up
    [goals] all goals were reached
   *[other] because of "{ $reason }"
}.
# A goal won the game; $robot is the name of the robot that reached it.
why-team-won = { $team } won the game at { $time } s: the goal "{ $goal }" was reached ({ $robot }).
why-robot-won = { $robot } won the game at { $time } s: it reached the goal "{ $goal }".
why-no-goal = This world has no goal.
why-no-events = The log has nothing that the program did.
why-unknown = The log does not say why.
why-left-loop = { why-first-line-does } left the loop at { $time } s.
why-own-name = { why-first-line-does } changed another { $name }: the one that belongs to { $function } alone.
why-own-place = { $function } in { why-line } has its own { $name }, because it is one of its parameters.
why-camera = The camera was tilted to { $angle }°: { why-line-does } set it at { $time } s.
why-meanwhile = Meanwhile the robot was told to { $motion }: { why-line-says }.
why-not-happened = That had not happened by { $time } s.
why-there-is-more = { $count ->
    [one] There is one more cause: add --more.
   *[other] There are { $count } more causes: add --more.
}
why-start-over = "when start" in { why-line } runs only once; it was over at { $time } s.
why-turn = It was turn { $count } of the loop in { why-line-code }.
why-not-then = At { $time } s the robot was told something else.
why-never-told = No line { $possible ->
    [true] had told the robot to move by { $time } s.
   *[other] of your program tells the robot to move.
}
why-stops-at-end = When a program is over, its robot stops.
why-turns-over = The loop in { why-line-does } was over at { $time } s{ $count ->
    [0] .
    [one] , after one turn.
   *[other] , after { $count } turns.
}
why-never-read = { why-first-line-does } sets { $name }, but no line reads { $name }.
why-result-lost = { why-first-line-does } gave { $value } at { $time } s, but nothing uses what { $name } gives.
why-last-line = { why-first-line-does } was the last one of { $name } that ran, and it is no "return".
why-same-list = { why-first-line-does } copies no list: { $name } is only another name for it.

why-loop-goes-on = { $endless ->
    [true] The loop in { why-line-does } never ends by itself.
   *[other] The loop in { why-line-does } was still going on at { $time } s{ $facts }.{ $closest }
}
why-when-goes-on = A program with events goes on as long as one of them can run: "when { $name }" in { why-line } was active at { $time } s.
why-no-acts = No line of your program makes the robot do anything.
why-paused = { why-first-line-does } waited for { $seconds } s in all.
why-line-not-asked = No line of your program looked for a line on the floor.
why-line-never-seen = { why-first-line-does } never saw the line.
why-line-seen = { why-first-line-does } saw the line at { $time } s, and then not for long.
why-no-floor = There was no floor under a sensor at { $time } s.
why-only-each-other = "when { $name }" in { why-line } was not active: only events that had not run start it.
why-decimals = A computer stores most decimals only nearly: 0.1 + 0.2 is 0.30000000000000004. Ask for less or more, or round first.
why-never-stopped = "when { $name }" in { why-line } runs again and again: no line stops it.
why-not-between = That did not happen between { $since } and { $time } s.
why-not-yet = { why-first-line-does } changes { $name }, too, but had not run yet.

## Two runs of one program.

why-parted = At { $time } s { why-line-does } was { $answer ->
    [true] true{ $facts }.
   *[other] not true{ $facts }.
}
why-parted-turn = At { $time } s { why-line-does } began another turn.
why-parted-ended = This run was over at { $time } s.
why-parted-acted = At { $time } s { why-line-does } told the robot what to do next.
why-parted-because = At { $time } s { why-line-does } was { $answer ->
    [true] true in the first run, because { $one }, and not true in the second, because { $other }.
   *[other] not true in the first run, because { $one }, and true in the second, because { $other }.
}
why-same = Both runs made the same decisions.
why-together = Both runs made the same decisions until { $time } s.
why-run = { $name }: { $sentence }
why-cause-edit = Line { $line } was edited: { $before } became { $after }.
why-cause-added = Line { $line } was added: { $after }.
why-cause-removed = Line { $line } was removed: { $before }.
why-cause-more = { $count ->
    [one] One more line differs.
   *[other] { $count } more lines differ.
}
why-cause-robot = The first run was on { $one }, the second on { $other }.
why-cause-world = The first run was in the world { $one }, the second in { $other }.
why-cause-variant = The world { $world } was not the same: another variant of it, or it was edited.
why-cause-seed = The runs had different seeds, { $one } and { $other }, so the noise of their sensors and wheels differed.
why-cause-start = The robot was put at another place before the run.
why-cause-hand = The robot was moved by hand, or keys were pressed, at other moments.
why-cause-real = A real robot never does exactly the same twice.
why-cause-length = One run was stopped before the other.

# Things in our worlds, by their English names.

why-name = { $word ->
    [box] a box
    [block] a block
    [crate] a crate
    [ball] a ball
    [barrel] a barrel
    [cone] a cone
    [house] a house
    [lamp] a lamp
    [pile] a pile of blocks
    [planet] a planet
    [post] a post
    [rocket] a rocket
    [tree] a tree
    [flowers] flowers
    [cylinder] a cylinder
    [light-box] a light box
    [light-cylinder] a light cylinder
    [red-pillar] the red pillar
    [blue-pillar] the blue pillar
    [green-pillar] the green pillar
    [wall] a wall
    [border] the world's edge
    [tag] tag { $rest }
    [face] { $rest ->
        [joy] a happy face
        [sadness] a sad face
        [anger] an angry face
        [fear] a scared face
        [disgust] a disgusted face
        [surprise] a surprised face
       *[other] a face
    }
   *[other] { $name }
}
