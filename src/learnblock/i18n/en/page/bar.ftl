# The bar at the top of the page.

page-bar-run = Run
page-bar-stop = Stop
page-bar-pause = Pause
page-bar-resume = Resume
page-bar-pause-or-resume = Pause or resume
page-bar-step = Step
page-bar-step-over = Step over functions
page-bar-restart = Restart
page-bar-running = Run controls
page-bar-undo = Undo
page-bar-redo = Redo
page-bar-speed = Speed
page-bar-times = { $factor }×
page-bar-free = Fastest
page-bar-robot = Robot
page-bar-simulated = simulated
page-bar-robots-simulated = Simulated
page-bar-robots-real = Real
# $name is what the user calls the robot, $robot its kind.
page-bar-named-robot = { $name } ({ $robot })
# A robot that is not simulated. $robot: its name
page-bar-real-robot = { $robot } (real)
page-bar-world = World
page-bar-worlds = Worlds
page-bar-own-worlds = My worlds
page-bar-edit-world = Edit world
page-bar-language = Language
page-bar-theme = Theme
page-bar-stage = Stage
page-bar-stage-starter = Starter
page-bar-stage-explorer = Explorer
page-bar-stage-coder = Coder
page-bar-more = Settings and help
page-bar-state-idle = Ready
page-bar-state-starting = Starting
page-bar-state-running = Running
page-bar-state-paused = Paused
page-bar-state-held = Paused
page-bar-held-breakpoint = Paused at breakpoint
page-bar-held-step = Paused after a step
page-bar-held-pause = Paused
page-bar-state-input = Waiting for your answer
page-bar-state-done = Finished; other robots are running
page-bar-state-ended = Ended
page-bar-world-robots = { $title } ({ $count } robots)
