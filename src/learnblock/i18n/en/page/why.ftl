# Questions about a run.

page-why-none = Run the program, then ask why the robot did what it did.
page-why-search = Search the questions
page-why-happened = What happened
page-why-did-not = What did not happen
page-why-values = Variables
page-why-lines = Lines
page-why-back = All questions
page-why-more = { $count ->
    [one] One more reason
   *[other] { $count } more reasons
}
page-why-look = See { $seconds } s
page-why-block = Show the block
page-why-goal = Why?
page-why-ask-block = Why did it run, or not?
page-why-goal-missed = Goal not reached. Why?
page-why-robot = Why is the robot doing this?
page-why-moment = Other questions about this moment
page-why-variable = Why is it like this?
page-why-printed = Why was this printed?
page-why-mark = { $what }: why?
# $subject is a block in its own words, $time such as " at 2.5 s".
page-why-ask-print-block = Why did the block “{ $subject }” print its text{ $time }?
page-why-ask-not-print-block = Why did the block “{ $subject }” not print its text{ $time }?
page-why-ask-line-block = Why did the block “{ $subject }” run{ $time }?
page-why-ask-not-line-block = Why did the block “{ $subject }” not run{ $time }?
