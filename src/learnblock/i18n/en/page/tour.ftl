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
page-tour-blocks-title = Build with blocks
page-tour-blocks = Drag blocks from the list and snap them together. Each block tells the robot to do something.
page-tour-texts-title = The same program as text
page-tour-texts = Block-Text and Python show the same program as text. Change one view, and the others follow as you type.
page-tour-run-title = Run it
page-tour-run = The green button runs your program, and the red one stops it. You can also pause it, step through it or restart it.
page-tour-world-title = Watch the robot
page-tour-world = This is the robot in its world. When no program is running, you can drag it somewhere else. The camera and joystick are above, and the output is below.
page-tour-robot-title = Try another robot
page-tour-robot = The same program runs on other robots and in other worlds. Choose them here, then run it again.
