# Hints for a program that fails the checks of a lesson. Of each: what to look at, which part, how in
# general, and for the teacher why it was chosen. None may say what to write.
# $where: "line 3" or "lines 3, 5". Values are explained where they are used.

hint-where-line = line { $line }
hint-where-lines = lines { $lines }
hint-a-loop = a loop
hint-a-sensor = a sensor
hint-a-line-sensor = a sensor that sees lines
hint-a-distance-sensor = a sensor that sees what is ahead
hint-the-other-side = the sensor on the other side
hint-no-reason = A check is not met.

# $message: of the error
hint-error-look = An error ended your program: { $message }
hint-error-part = It happened in { $where }. What is special about the values there at that moment?
hint-error-how = Read the message slowly: it names the thing that could not be done. Then go back, step by step, to where that value came from.
hint-error-because = The run ended with an error.

hint-empty-look = Your program has no commands yet, so the robot does nothing.
hint-empty-part = Look at { $where }.
hint-empty-how = Tell the task in your own words, one small action after the other. Each action becomes a block.
hint-empty-because = The program has no statement that does anything.

hint-empty-body-look = One of your blocks is empty inside.
hint-empty-body-part = Look at { $where }: what should happen there?
hint-empty-body-how = A loop, a condition or a function only does what is put inside it.
hint-empty-body-because = A block with a body has nothing in it.

# $name: of the event
hint-never-started-look = A part of your program is never started.
hint-never-started-part = Look at { $where }: what makes "{ $name }" begin?
hint-never-started-how = An event without a condition sleeps until another part of the program wakes it.
hint-never-started-because = The event "{ $name }" has no condition, and nothing activates it.

# $name: of the function
hint-not-called-look = You made a function, but the robot never does it.
hint-not-called-part = Look at { $where }: who uses "{ $name }"?
hint-not-called-how = Defining a function only teaches the robot a new word. It acts when the program says that word.
hint-not-called-because = The function "{ $name }" is defined and never called.

hint-unreachable-look = The robot never gets to the last part of your program.
hint-unreachable-part = Look at { $where }: how does the program get from one to the other?
hint-unreachable-how = What comes after a loop that repeats forever is never reached. A loop can also end when something becomes true.
hint-unreachable-because = Statements come after a loop that nothing can leave.

# $name: of the message
hint-message-name-look = Your robot waits for a message that never comes.
hint-message-name-part = Look at { $where }: does anybody send "{ $name }"?
hint-message-name-how = Sender and receiver must use exactly the same name for a message.
hint-message-name-because = The program asked for the message "{ $name }", which no robot sent.

hint-text-almost-look = One text is almost right. Compare it letter by letter with the task.
hint-text-almost-part = It comes from { $where }.
hint-text-almost-how = A computer compares texts exactly: every letter, space and sign counts.
hint-text-almost-because = A text in the run is very similar to the one that the check asks for.

hint-no-wait-look = One command is over before you can see it. Run the program slowly and watch.
hint-no-wait-part = Look at { $where }: how much time passes after that command?
hint-no-wait-how = Some commands only start something, and the next command takes over at once. The robot needs time in between.
hint-no-wait-because = A command was replaced, or the program ended, before any time had passed.

hint-repetition-look = Your program does the same thing several times in a row.
hint-repetition-part = Compare what begins in { $where }.
hint-repetition-how = What comes again and again is written once, inside a loop.
hint-repetition-because = The program is too large, and equal statements follow each other.

hint-too-large-look = Your program is longer than it needs to be.
hint-too-large-part = Look at { $where }.
hint-too-large-how = Look for parts that are alike, or that change nothing: a loop or a function can take their place.
hint-too-large-because = The program has more blocks than the check allows.

# $joined: and, or
hint-impossible-condition-look = One of your conditions always has the same answer.
hint-impossible-condition-part = Look at { $where } and try some numbers: when is it true, when is it false?
hint-impossible-condition-how = With "and" both parts must be true at once. With "or" one of them is enough.
hint-impossible-condition-because = Two comparisons joined by "{ $joined }" can never both hold, or one of them always does.

hint-wrong-side-look = Watch what the robot does when it sees something on one side.
hint-wrong-side-part = Look at { $where }: to which side does the robot turn there, and to which side should it?
hint-wrong-side-how = A robot turns towards a line to stay on it, and away from an obstacle to pass it.
hint-wrong-side-because = A sensor on one side is answered by a turn to the wrong side.

# $name: of the variable
hint-unchanged-variable-look = A loop waits for a value that stays the same.
hint-unchanged-variable-part = Look at the loop in { $where }: where does "{ $name }" change?
hint-unchanged-variable-how = A loop with a condition ends only if something inside it changes what the condition asks.
hint-unchanged-variable-because = Nothing in the loop changes the variable "{ $name }" of its condition.

# $what: such as "the skill turn", from the words of checks
hint-used-too-often-look = Your program uses something more often than the task allows: { $what }.
hint-used-too-often-part = Look at { $where }.
hint-used-too-often-how = Could one of them do the work of the others, in a loop or in a function?
hint-used-too-often-because = The check allows fewer: { $what }.

hint-not-used-look = The task asks for something that your program does not have yet: { $what }.
hint-not-used-part = Look at { $where }.
hint-not-used-how = Read the task again: it says what this part is good for. The palette has a block for it.
hint-not-used-because = The check asks for it, and the program has none or too few: { $what }.

hint-no-loop-look = Does your program do something again and again? Think of: { $what }.
hint-no-loop-part = Compare what begins in { $where }: it is the same.
hint-no-loop-how = What happens more than once belongs into a loop: for a number of times, while something is true, or forever.
hint-no-loop-because = The program repeats itself, or the check asks for a loop, and there is none.

hint-checked-once-look = The robot looks only once, at the very beginning.
hint-checked-once-part = Look at { $where }: when is this question asked, and how often?
hint-checked-once-how = A question is answered at the moment when it is asked. To notice something later, the robot must ask again and again.
hint-checked-once-because = An "if" asks a sensor outside any loop.

hint-loop-without-wait-look = One of your loops is finished in no time.
hint-loop-without-wait-part = Look at the loop in { $where }: how long does one round take?
hint-loop-without-wait-how = A loop that never waits goes round as fast as the computer can, and the robot sees only the last command.
hint-loop-without-wait-because = A loop drives the robot, and no time passes in it.

hint-never-ends-look = Your program never ends by itself.
hint-never-ends-part = Look at the loop in { $where }: what would make it stop?
hint-never-ends-how = Ask yourself when the task is done, and how the robot can notice it. The loop should go on only until then.
hint-never-ends-because = The program ran until its time was over.

hint-opposite-condition-look = One of your questions may be the wrong way round.
hint-opposite-condition-part = Look at { $where }: say the sentence aloud. What does the robot do when the answer is yes?
hint-opposite-condition-how = "While" goes on as long as the answer is yes; "wait until" goes on as soon as it is yes. "Not" turns an answer round.
hint-opposite-condition-because = A condition is over at once, or answers an obstacle by driving on.

hint-motors-on-look = Watch the robot when its task is done: do its wheels still turn?
hint-motors-on-part = Look at { $where }: what ends this movement?
hint-motors-on-how = A drive command goes on until the next one. A robot that should stand still has to be told so.
hint-motors-on-because = The last command to the wheels still lasted when the run ended.

hint-other-robot-look = Your program works on one robot, and not on this one.
hint-other-robot-part = Look at the numbers in { $where }: do they fit every robot?
hint-other-robot-how = Robots differ in size, speed and sensors. A program that asks the sensors, or that names a distance instead of a time, suits more of them.
hint-other-robot-because = All checks are met on the usual robot.

hint-wrong-order-look = Everything happens, but not in this order. Tell the story of the task again.
hint-wrong-order-part = Look at { $where }: which comes first?
hint-wrong-order-how = A program does one thing after the other, from top to bottom.
hint-wrong-order-because = Everything that the check asks for happened, in another order.

hint-wrong-sign-look = Watch in which direction the robot drives.
hint-wrong-sign-part = The movement from { $where } goes the opposite way.
hint-wrong-sign-how = The sign of a number gives the direction: a number below zero means backwards.
hint-wrong-sign-because = With this movement the other way round, the robot would have come to the right place.

hint-wrong-direction-look = Stand behind the robot and watch: to which side does it turn?
hint-wrong-direction-part = The turn from { $where } goes to the other side.
hint-wrong-direction-how = Left and right are those of the robot, not yours. With an angle, the sign gives the side.
hint-wrong-direction-because = With this turn to the other side, the robot would have come to the right place.

# $what: what is missing, such as "a sensor"
hint-never-asks-look = Does the robot look where it is going? Something is never asked: { $what }.
hint-never-asks-part = Look at { $where }: how could the robot know at that moment that something is there?
hint-never-asks-how = A robot notices only what its program asks the sensors.
hint-never-asks-because = The run never asked what it needed: { $what }.

hint-only-here-look = Your program works in one world, and fails when the world is a little different.
hint-only-here-part = Look at the numbers in { $where }: what if the way is longer or shorter?
hint-only-here-how = Counting time or distance works only where nothing changes. A sensor tells what is really there.
hint-only-here-because = All checks are met in the world as it is drawn, but not in a variant.

hint-never-runs-look = One part of your program never ran.
hint-never-runs-part = It is the part that begins in { $where }. What must be true before the robot gets there, and was it ever?
hint-never-runs-how = Watch the values that a condition compares while the program runs. Is the number or the name the right one?
hint-never-runs-because = These statements did not run, although the program did.

# $thing: what was hit; $time: seconds
hint-collision-look = The robot bumped into something ({ $thing }) after { $time } s. Watch that moment again.
hint-collision-part = It was moving because of { $where }.
hint-collision-how = Think of how far the robot needs to stop or to turn: it has to react early enough.
hint-collision-because = The robot hit "{ $thing }" at { $time } s.

hint-forbidden-look = Something happens that the task does not want. Read the goals again.
hint-forbidden-part = It comes from { $where }.
hint-forbidden-how = Find the moment in the run when it happens, and what the program was doing just then.
hint-forbidden-because = An event happened that must never happen.

hint-never-stands-look = The robot should stand still for a while. Does it?
hint-never-stands-part = Look at { $where }.
hint-never-stands-how = Standing still takes two things: wheels that stop, and time that passes before the next command.
hint-never-stands-because = The robot never stood still as long as the check asks for.

# $kind: print, say, show
hint-wrong-text-look = { $kind ->
    [print] Compare what your program prints with what the task asks for.
    [say] Compare what the robot says with what the task asks for.
   *[show] Compare what the robot shows with what the task asks for.
}
hint-wrong-text-part = Look at { $where }.
hint-wrong-text-how = If a value is in it, follow that value back: where was it set, and where did it change?
hint-wrong-text-because = Something was printed, said or shown, but not what the check asks for.

hint-not-shown-look = { $kind ->
    [print] Your program prints nothing, and the task asks for a text.
    [say] The robot says nothing, and the task asks for words.
   *[show] The robot shows nothing, and the task asks for it.
}
hint-not-shown-part = Look at { $where }.
hint-not-shown-how = People see only what a program shows, says or prints. Which block makes this visible, and when should it run?
hint-not-shown-because = Nothing was printed, said or shown.

hint-event-missing-look = Something that the task asks for never happens.
hint-event-missing-part = Look at { $where }.
hint-event-missing-how = Go through the goals one by one and find the block that makes each of them true.
hint-event-missing-because = A skill was never called, or a message never sent.

hint-no-turn-look = Compare the robot's way with the task: is there a corner where it should turn?
hint-no-turn-part = Look before { $where }: in which direction does the robot look there?
hint-no-turn-how = Walk the way yourself. Count the straight parts and the turns between them.
hint-no-turn-because = The robot drove straight on where its way has a corner.

hint-too-few-times-look = Count: how often does it happen, and how often should it?
hint-too-few-times-part = Look at the loop in { $where }: how many rounds does it make?
hint-too-few-times-how = Count the rounds on your fingers, with the first one and the last one.
hint-too-few-times-because = It happened less often than it should.

hint-too-many-times-look = Count: how often does it happen, and how often should it?
hint-too-many-times-part = Look at the loop in { $where }: how many rounds does it make?
hint-too-many-times-how = Count the rounds on your fingers, with the first one and the last one.
hint-too-many-times-because = It happened more often than it should.

hint-value-too-small-look = Compare where the robot is with where it should be: something is not enough.
hint-value-too-small-part = Look at the number in { $where }.
hint-value-too-small-how = A number in a block is a measure: how far, how long, how fast, or how near. Change one number at a time and watch.
hint-value-too-small-because = With a larger number there, the robot would have come to the right place.

hint-value-too-large-look = Compare where the robot is with where it should be: something is too much.
hint-value-too-large-part = Look at the number in { $where }.
hint-value-too-large-how = A number in a block is a measure: how far, how long, how fast, or how near. Change one number at a time and watch.
hint-value-too-large-because = With a smaller number there, the robot would have come to the right place.

hint-lost-line-look = Watch the place where the robot leaves the line. What did it see just before?
hint-lost-line-part = Look at { $where }.
hint-lost-line-how = For every way in which the line can be under the robot, decide what it should do, also when it sees no line at all.
hint-lost-line-because = The program asks for the line, and the robot loses it.

hint-never-moved-look = The robot does not move at all.
hint-never-moved-part = Look at { $where }.
hint-never-moved-how = Which block makes the wheels turn? Does the program get there, and does it take any time?
hint-never-moved-because = The robot stayed where it was.

hint-too-early-look = Your program ends before everything is done.
hint-too-early-part = Look at { $where }.
hint-too-early-how = Compare your program with the task, sentence by sentence: which part is still missing at the end?
hint-too-early-because = The program ended by itself before the check was met.

hint-too-late-look = It takes too long. Where does the robot lose time?
hint-too-late-part = Look at { $where }.
hint-too-late-how = Look for long waits, slow speeds and ways that are longer than they need to be.
hint-too-late-because = It did not happen in the time that the check allows.

# $reason: what the check says
hint-look-again-look = { $reason }
hint-look-again-part = Look at { $where }.
hint-look-again-how = Run the program slowly, and stop at the first moment when the robot does something else than you expected.
hint-look-again-because = No other rule fits.

# $number: of the rule in the lesson; $sign: one of the texts below
hint-teacher-because = Rule { $number } of the lesson fits: { $sign }.
hint-sign-none = its check fails
hint-sign-never-asks = something is never asked
hint-sign-never-runs = something never runs
hint-sign-loop-without-wait = a command has no time
hint-sign-wrong-sign = a direction is the opposite one
hint-sign-value-too-small = a value is too small
hint-sign-value-too-large = a value is too large
hint-sign-no-loop = a loop is missing
hint-sign-too-early = the program ends too early
hint-sign-too-late = it takes too long
hint-sign-collision = the robot bumps into something
hint-sign-error = an error ends the program
hint-sign-empty = something is empty
