# The view of the world.

page-world-label = The world. Arrow keys turn the view, plus and minus zoom, W says where the robot is, V shows other robots, and P places the robot with the keyboard.
page-world-image = World: { $title }.
page-world-image-empty = The world is empty.
page-world-no3d = This browser can't show the world in 3D. Programs still run. To see the world, turn on hardware acceleration or WebGL in the browser's settings, or use a newer browser.
page-world-toolbar = View
page-world-eye = View and robot
page-world-this = This world
page-world-shown = Shown
page-world-values = Values of the robot
page-world-plot = Plot these values
# $thing is such as "a wall".
page-world-goal = Goal: { $goal }
# A goal of a team, which has a name such as Red.
page-world-goal-of-team = { $goal } ({ $team })
page-world-team = { $team } team
page-world-goal-of = Goal { $number } of { $all }: { $goal }
page-world-free-play = Free play
page-world-free-play-help = This world has no goal: make the robot do what you like. The worlds of the menu above have goals.
page-world-bumped = Bump: { $thing }
page-world-real-speed = { $factor }×: as fast as this computer can
page-world-mm = { $mm } mm
page-world-nothing-near = nothing near
page-world-degrees = { $degrees }°
page-world-tool-eye = Robot's eye view
page-world-tool-orbit = Look around
page-world-tool-follow = Follow the robot
page-world-tool-top = View from above
page-world-tool-split = Next view of the robots
page-world-players-all = Follow all robots
# $first and $second are the names of robots.
page-world-players-split = Side by side: { $first } and { $second }
page-world-players-one = Follow { $first }
page-world-tool-nearer = Zoom in
page-world-tool-farther = Zoom out
page-world-tool-whole = Show the whole world
page-world-tool-trail = Show the robot's trail
page-world-tool-beams = Show distance sensor beams
page-world-tool-place = Place robot with keyboard
page-world-tool-where = Where is the robot?
page-world-tool-why = Why is the robot doing this?
page-world-hand = Shake and tilt the robot
page-world-tool-shake = Shake robot
page-world-tool-front = Tilt robot forward
page-world-tool-back = Tilt robot backward
page-world-tool-left = Tilt robot to the left
page-world-tool-right = Tilt robot to the right
page-world-placing = Arrow keys move the robot by 10 mm (Shift: 100 mm); comma and full stop turn it. Press Escape to finish.
# $keys: those that programs ask for; $programs: how many do.
page-world-keys-wanted = { $programs ->
    [one] The program listens to { $keys }. Click the world to press them.
   *[other] The programs listen to { $keys }. Click the world to press them.
}
page-world-keys-heard = { $programs ->
    [one] The program listens to { $keys }.
   *[other] The programs listen to { $keys }.
}
page-world-keys-all = all letters, digits, arrows, space and enter
page-world-key-space = space
page-world-key-enter = enter
page-world-placed = The robot stays here.
page-world-not-now = The robot can't be moved while a program is running. Pause or stop the program first.
page-world-robot = { $robot } at { $place }
page-world-place = { $x }, { $y }, facing { $direction }
page-world-east = { $mm } mm east
page-world-west = { $mm } mm west
page-world-north = { $mm } mm north
page-world-south = { $mm } mm south
page-world-direction-e = east
page-world-direction-se = south-east
page-world-direction-s = south
page-world-direction-sw = south-west
page-world-direction-w = west
page-world-direction-nw = north-west
page-world-direction-n = north
page-world-direction-ne = north-east
page-world-nothing-ahead = nothing ahead within { $mm } mm
page-world-something-ahead = obstacle { $mm } mm ahead
page-world-emotion = showing { $emotion }
page-world-emotion-joy = joy
page-world-emotion-sadness = sadness
page-world-emotion-anger = anger
page-world-emotion-fear = fear
page-world-emotion-disgust = disgust
page-world-emotion-surprise = surprise
page-world-emotion-neutral = a neutral face
page-world-text = showing “{ $text }”
page-world-goal-reached = Goal reached: { $name }.
page-world-goal-failed = Goal failed: { $name }.
page-world-goal-open = Goal not reached yet: { $name }.

# The themes of worlds.

page-world-kind-ball = Ball
page-world-kind-barrel = Barrel
page-world-kind-block = Block
page-world-kind-cone = Traffic cone
page-world-kind-crate = Crate
page-world-kind-flowers = Flowers
page-world-kind-house = House
page-world-kind-lamp = Street lamp
page-world-kind-pile = Pile of blocks
page-world-kind-planet = Planet
page-world-kind-post = Post
page-world-kind-rocket = Rocket
page-world-kind-tree = Tree
page-world-kind-anything = Anything
page-world-kind-star = Star
page-world-kind-coin = Coin
page-world-kind-gem = Gem
page-world-kind-heart = Heart
page-world-kind-cherry = Cherry
page-world-kind-battery = Battery
page-world-kind-key = Key
page-world-kind-flag = Flag
page-world-kind-bug = Bug
page-world-kind-ghost = Ghost
page-world-ends-no = no
page-world-ends-win = won
page-world-ends-lose = lost
page-world-when-entered = entered
page-world-when-left = left
page-world-time-up-lose = it is lost
page-world-time-up-win = it is won
page-world-time-up-program = the program decides
page-world-theme-playground = Playground
page-world-theme-city = City
page-world-theme-space = Space
page-world-theme-warehouse = Warehouse
page-world-theme-garden = Garden
page-world-theme-night = Night
page-world-theme-maze = Maze

# A game: its score, its lives and its time.
page-world-game-label = Game
page-world-game-score = Score: { $score }
page-world-game-lives = Lives: { $lives }
page-world-game-time = Time left: { $seconds } seconds
page-world-game-won = You win
page-world-game-team-wins = { $team } wins
page-world-game-robot-wins = { $robot } wins
# The goal that has won the game, and the robot of the team that reached it.
page-world-game-goal-by = { $goal } ({ $robot })
page-world-game-over = Game over
page-world-game-time-up = Time is up
page-world-game-no-lives = No lives left
page-world-game-again = Play again
page-world-game-watch = Watch again
page-world-game-close = Close

# The end of a run, shown again.
page-world-replay-label = Replay
page-world-replay-title = The last { $seconds } seconds
page-world-replay-film = Save as film
page-world-replay-stop = Stop
