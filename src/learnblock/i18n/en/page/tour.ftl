# The tour of the page.

page-tour-title = Page tour
page-tour-offer = New here? Take a one-minute tour.
page-tour-begin = Start tour
page-tour-decline = No, thanks
page-tour-step = Step { $number } of { $all }
page-tour-skip = End tour
page-tour-back = Back
page-tour-next = Next
page-tour-done = Done
page-tour-add-title = Add a block
page-tour-add = Open Move, and drag a block to your program, or press Enter on it.
page-tour-change-title = Change a number
page-tour-change = Click a number in a block, and type another one.
page-tour-run-title = Run it
page-tour-run = Press the green button, and watch the robot.
page-tour-texts-title = See it as text
page-tour-texts = The same program as text: choose Block-Text or Python. Change one, and the others follow.
page-tour-robot-title = Try another robot
page-tour-robot = The same program runs on other robots. Choose one here, then run it again.
page-tour-well-done = Done!
