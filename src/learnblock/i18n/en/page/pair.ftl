# Playing with a classmate in one world.

page-pair-menu = Play with a classmate…
page-pair-title = Play with a classmate
page-pair-how = Your classmate's program drives the second robot in your world. You start the run.
page-pair-none-here = You can't invite any of your classmates at the moment.
page-pair-inviting = You have invited { $name }. Wait for an answer.
page-pair-take-back = Take invitation back
# $robot is the name of a robot.
page-pair-invited = { $name } invites you to drive the robot { $robot } with your program, in { $name }'s world.
page-pair-accept = Play
page-pair-decline = Not now
# $robot is the name of a robot.
page-pair-host = { $name }'s program drives the robot { $robot } in your world. Press Run to start both.
page-pair-host-away = { $name } does not see your world at the moment.
# $robot is the name of a robot.
page-pair-guest = Your program drives the robot { $robot } in { $name }'s world. { $name } starts the run.
page-pair-world = { $name }'s world
page-pair-own-world = Show my world
page-pair-their-world = Show { $name }'s world
page-pair-leave = Stop playing together
