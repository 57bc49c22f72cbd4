page-tabs-label = Robots
page-tabs-add-help = Add robots
page-tabs-add-title = Add robots
page-tabs-add-action = Add
page-tabs-add-count = Robots to add
page-tabs-program = Program
page-tabs-new-program = New program
page-tabs-new-program-help = The robots get a tab with an empty program.
# $name is a tab.
page-tabs-same-program = Same program as { $name }
page-tabs-same-program-help = The robots share one program: you edit it once for all of them.
page-tabs-count = Number of robots
page-tabs-count-menu = Number of robots...
page-tabs-count-title = Robots that run { $name }
page-tabs-count-action = Change
# Beside the name of a program that several robots run.
page-tabs-times = ×{ $count }
page-tabs-shown = Robot shown
page-tabs-robot-state = { $name }: { $state }
page-tabs-close = Close { $name }
page-tabs-closed = { $name } and its program are closed.
page-tabs-reopen = Undo
page-tabs-rename = Rename { $name }
page-tabs-rename-title = Rename robot
page-tabs-rename-help = Messages, goals and the world use this name.
page-tabs-rename-action = Rename
page-tabs-failed = Failed
page-tabs-mistakes = The program has errors
