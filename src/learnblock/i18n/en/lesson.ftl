# Lessons: their files, their checks in words, and why a check failed.

# Files of lessons. $file is a path in the lesson.
lesson-file-type = There is no lesson here. Give a folder with a lesson, or a file that ends in { $ending }.
lesson-no-main-file = This is not a lesson: it has no { $file }.
lesson-newer = This lesson was made with a newer LearnBlock: version { $version } of the format. Update LearnBlock.
lesson-missing-file = The lesson has no file '{ $file }'.
lesson-zip-damaged = This file is damaged or not a lesson.
lesson-unknown-file = A lesson cannot have a file '{ $file }'. Remove it, or see docs/lessons.md for the files of a lesson.
lesson-too-many-files = A lesson can have at most { $most } files.
lesson-uses-one = Give exactly one of 'construct', 'skill' and 'function'.
lesson-quiz-without-answer = None of the answers is right. Write 'right = true' in at least one.
lesson-text-blocks = The code block 'blocks' of this text is not Block-Text: { $problem }
lesson-text-braces = The braces of this text don't match: { $reason }. Write '{ "{{" }' for a brace.
lesson-text-values = The text '{ $name }' has other values in '{ $language }'.
lesson-partner-name = Another robot is already called '{ $name }'. Choose another name.
lesson-puzzle-program = This order is not a program in Block-Text: { $problem }
lesson-puzzle-pieces = This order has other pieces than '{ $file }'. Use the same statements in both.

# How often something happens.
lesson-times = { $count ->
        [1] once
        [2] twice
       *[other] { $count } times
    }

# Events. $form: a sentence, that it never happens, that it did not (missing) or did (past), or a part of a sentence.
lesson-event-goal = { $form ->
    [sentence] The goal '{ $name }' is reached
    [never] The goal '{ $name }' is never reached
    [missing] The goal '{ $name }' was not reached
    [past] The goal '{ $name }' was reached
   *[clause] the goal '{ $name }' is reached
}
lesson-event-shows = { $form ->
    [sentence] The robot shows '{ $what }'
    [never] The robot never shows '{ $what }'
    [missing] The robot did not show '{ $what }'
    [past] The robot showed '{ $what }'
   *[clause] the robot shows '{ $what }'
}
lesson-event-shows-any = { $form ->
    [sentence] The robot shows something
    [never] The robot never shows anything
    [missing] The robot did not show anything
    [past] The robot showed something
   *[clause] the robot shows something
}
lesson-event-says = { $form ->
    [sentence] The robot says '{ $what }'
    [never] The robot never says '{ $what }'
    [missing] The robot did not say '{ $what }'
    [past] The robot said '{ $what }'
   *[clause] the robot says '{ $what }'
}
lesson-event-says-any = { $form ->
    [sentence] The robot says something
    [never] The robot never says anything
    [missing] The robot did not say anything
    [past] The robot said something
   *[clause] the robot says something
}
lesson-event-prints = { $form ->
    [sentence] The program prints '{ $what }'
    [never] The program never prints '{ $what }'
    [missing] The program did not print '{ $what }'
    [past] The program printed '{ $what }'
   *[clause] the program prints '{ $what }'
}
lesson-event-prints-any = { $form ->
    [sentence] The program prints a line
    [never] The program never prints anything
    [missing] The program did not print anything
    [past] The program printed a line
   *[clause] the program prints a line
}
lesson-event-calls = { $form ->
    [sentence] The program uses { $skill }
    [never] The program never uses { $skill }
    [missing] The program did not use { $skill }
    [past] The program used { $skill }
   *[clause] the program uses { $skill }
}
lesson-event-sends = { $form ->
    [sentence] The program sends the message '{ $message }'
    [never] The program never sends the message '{ $message }'
    [missing] The program did not send the message '{ $message }'
    [past] The program sent the message '{ $message }'
   *[clause] the program sends the message '{ $message }'
}
lesson-event-collision = { $form ->
    [sentence] The robot bumps into something
    [never] The robot never bumps into anything
    [missing] The robot did not bump into anything
    [past] The robot bumped into something
   *[clause] the robot bumps into something
}
lesson-event-collision-with = { $form ->
    [sentence] The robot bumps into '{ $thing }'
    [never] The robot never bumps into '{ $thing }'
    [missing] The robot did not bump into '{ $thing }'
    [past] The robot bumped into '{ $thing }'
   *[clause] the robot bumps into '{ $thing }'
}
lesson-event-at = { $form ->
    [sentence] The robot comes within { $radius } mm of the place ({ $x }, { $y })
    [never] The robot never comes within { $radius } mm of the place ({ $x }, { $y })
    [missing] The robot did not come within { $radius } mm of the place ({ $x }, { $y })
    [past] The robot came within { $radius } mm of the place ({ $x }, { $y })
   *[clause] the robot comes within { $radius } mm of the place ({ $x }, { $y })
}
lesson-event-stands = { $form ->
    [sentence] The robot stands still for { $seconds } s
    [never] The robot never stands still for { $seconds } s
    [missing] The robot did not stand still for { $seconds } s
    [past] The robot stood still for { $seconds } s
   *[clause] the robot stands still for { $seconds } s
}

# The title of the block set of a step.
lesson-blocks = This lesson

# What a check asks for; $event is an event above, $check another of these sentences, $within nothing or lesson-within.
lesson-check-robot = { $robot }: { $check }
lesson-within = { " " }within { $seconds } s
lesson-check-all-goals = Reach all goals{ $within }.
lesson-check-goals = { $count ->
        [1] Reach the goal '{ $goals }'{ $within }.
       *[other] Reach the goals { $goals }{ $within }.
    }
lesson-check-happens = { $event }{ $within }.
lesson-check-at-least = { $event } at least { $least }{ $within }.
lesson-check-exactly = { $event } exactly { $times }{ $within }.
lesson-check-at-most = { $event } at most { $most }{ $within }.
lesson-check-between = { $event } at least { $least } and at most { $most }{ $within }.
lesson-check-never = { $event }.
lesson-check-order = These things happen in this order: { $events }.
lesson-check-order-within = These things happen in this order, with at most { $seconds } s between one and the next: { $events }.
lesson-check-line = Stay on the line '{ $line }' for { $share } % of the time.
lesson-check-drives = Drive at least { $least } mm.
lesson-check-drives-most = Drive at most { $most } mm.
lesson-check-drives-between = Drive at least { $least } mm and at most { $most } mm.
lesson-check-ends-at = Stop within { $radius } mm of the place ({ $x }, { $y }).
lesson-check-ends-facing = Stop within { $radius } mm of the place ({ $x }, { $y }), with the heading { $heading }°.
lesson-check-turns = Turn by { $by }° in all.
lesson-check-ends = The program runs to its end{ $within }.
lesson-check-prints = Print these lines in this order: { $lines }.
lesson-check-uses = Use { $what }.
lesson-check-uses-least = Use { $what } at least { $least }.
lesson-check-uses-most = Use { $what } at most { $most }.
lesson-check-uses-no = Do not use { $what }.
lesson-check-size = Use at most { $blocks } blocks.
lesson-check-python = The lesson's own check '{ $function }'.

# Parts of programs; $what above.
lesson-uses-skill = the block { $skill }
lesson-uses-function = your function { $function }
lesson-construct = { $construct ->
        [repeat] 'repeat'
        [forever] 'forever'
        [if] 'if'
        [else] 'else'
        [when] 'when'
        [function] a function of your own
        [parameter] a function with a parameter
        [return] 'return' with a value
        [variable] a variable
        [list] a list
        [print] 'print'
        [input] 'input'
       *[loop] a loop
    }

# Why a check failed.
lesson-goal-failed = The goal '{ $goal }' can't be reached any more.
lesson-goal-late = The goal '{ $goal }' was reached after { $at } s, but has to be reached within { $within } s.
lesson-goal-open = The goal '{ $goal }' was not reached.
lesson-goal-open-within = The goal '{ $goal }' was not reached within { $within } s.
lesson-no-goals = This world has no goals.
lesson-not-happened = { $event }.
lesson-happened = { $event } at { $at } s.
lesson-too-often = { $event } more than { $most }.
lesson-too-seldom = { $event } only { $times }; this has to happen at least { $least }.
lesson-too-late = { $event } at { $at } s; this has to happen within { $within } s.
lesson-order-late = { $waited } s went by, and at most { $within } s are allowed: first { $before }, then { $event }.
lesson-order-before = The order is wrong: first { $before }, and only then { $event }.
lesson-order-missing = { $event }; this has to come after something else: { $before }.
lesson-no-line = This world has no line '{ $line }'.
lesson-line-share = You stayed on the line for { $share } % of the time instead of { $asked } %.
lesson-line-lost = You stayed on the line for { $share } % of the time so far. Too little time is left to reach { $asked } %.
lesson-line-short = You drove { $driven } mm; drive at least { $least } mm.
lesson-drove-short = You drove { $driven } mm; drive at least { $least } mm.
lesson-drove-far = You drove { $driven } mm; at most { $most } mm are allowed.
lesson-no-pose = The robot's place is not known.
lesson-ended-away = The robot stopped { $away } mm away from the place; at most { $radius } mm are allowed.
lesson-ended-facing = The robot stopped at the right place, but { $off }° off its heading; at most { $angle }° are allowed.
lesson-turned = The robot turned by { $turned }° in all instead of { $by }°.
lesson-still-running = The program was still running after { $within } s.
lesson-ended-late = The program ended after { $at } s; it has to end within { $within } s.
lesson-ended-error = The program ended with an error.
lesson-ended-time = The program did not end before the time was up.
lesson-ended-otherwise = The program did not end by itself.
lesson-not-printed = The program did not print '{ $line }'.
lesson-printed-order = The program did not print '{ $line }' after '{ $before }'.
lesson-uses-none = Your program does not use { $what }.
lesson-uses-few = Your program uses { $what } only { $times } instead of at least { $least }.
lesson-uses-many = Your program uses { $what } { $times }; at most { $most } is allowed.
lesson-uses-not = Your program uses { $what }, which is not allowed here.
lesson-too-large = Your program has { $blocks } blocks; at most { $most } are allowed.

# The lesson's own Python; $error is Python's own text, $reason the lesson's.
lesson-expert-silent = The lesson's own check gave no answer.
lesson-expert-no-verdict = The lesson's own check got no answer within { $seconds } seconds, because this computer is too busy. This is not the fault of the program. Try again.
lesson-expert-error = The lesson's own check has a mistake: { $error }
lesson-expert-no = The lesson's own check was not met.
lesson-expert-says = { $reason }

# The command learnblock lesson: $mark is ✓ or ✗, $right and $all count attempts.
lesson-cli-solution = { $mark } Step { $step }: the solution { $file } passes in { $right } of { $all } attempts.
lesson-cli-wrong-program = { $mark } Step { $step }: the wrong program { $file } fails its check in { $right } of { $all } attempts.
lesson-cli-none = · Step { $step } has checks, but no solution.
lesson-cli-not-met = { $robot }, variant { $variant }: { $check } { $reason }
lesson-cli-not-caught = It does not fail the check '{ $check }'.
lesson-cli-other-hint = It should get the hint { $wanted } first, but gets: { $found }.
lesson-cli-no-hint = none
lesson-cli-wrong = { $wrong } of { $all } programs do not do what they should.
lesson-cli-right = The lesson is right: { $all } programs do what they should.
lesson-cli-attempt = { $robot }, variant { $variant }:
lesson-cli-hint = Hint ({ $rule }):
lesson-cli-packed = Written: { $file }

# learnblock lesson show: $number and $title are those of a step, $phase its part in PRIMM.
lesson-show-head = Level { $level } · { $minutes } min · { $robots }
lesson-show-step = Step { $number } ({ $phase }): { $title }
lesson-show-notes = Notes
lesson-show-solution = Solution
lesson-show-wrong = Typical wrong program; it fails this check: { $check }
lesson-show-hint = Hint
lesson-show-no-part = This copy of the lesson has no notes and no solutions.
# $title: of the lesson
lesson-copy-title = { $title } (copy)

# A lesson that is being edited on the page.
lesson-edit-no-text = Write this text, in one language at least.
lesson-edit-line = Line { $line }: { $problem }
lesson-edit-too-long = The programs of this lesson have { $length } characters together; at most { $limit } are allowed.
