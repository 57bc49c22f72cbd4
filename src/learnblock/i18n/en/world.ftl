# Simulated worlds and robots: their files, their pictures and the options of a run in them.

# Files of worlds. $place is the place of a value in the file, such as box[2].

world-off-floor = '{ $place }' is at ({ $x }, { $y }), outside the floor. On this floor, x goes from { $west } to { $east } and y from { $south } to { $north }.
# $group is the list in the file.
world-name-taken =
    { $group ->
        [line] Two lines are called '{ $name }'. Give each its own name.
        [start] Two starts are called '{ $name }'. Give each its own name.
        [team] Two teams are called '{ $name }'. Give each its own name.
       *[goal] Two goals are called '{ $name }'. Give each its own name.
    }
# $after is the goal that has to be reached before.
world-goal-circle = The goal '{ $name }' comes after '{ $after }', which comes after '{ $name }' itself. Remove one 'after'.
# A goal that a robot can't reach; $name is the goal's.
world-goal-off-floor = The goal '{ $name }' cannot be reached: it is outside the floor.
world-goal-behind-wall = The goal '{ $name }' cannot be reached: a wall is in the way.
world-goal-behind-box = The goal '{ $name }' cannot be reached: a box is in the way.
world-goal-behind-cylinder = The goal '{ $name }' cannot be reached: a cylinder is in the way.
world-goal-behind-board = The goal '{ $name }' cannot be reached: a tag or a face is in the way.
world-goal-behind-prop = The goal '{ $name }' cannot be reached: solid decoration is in the way.
world-goal-behind-border = The goal '{ $name }' cannot be reached: it is too close to the wall around the floor.
world-goal-behind-things = The goal '{ $name }' cannot be reached: several things are in the way.
world-path-part = Write each part of a path as {"{"} forward = 300 {"}"} or as {"{"} turn = 90, radius = 300 {"}"}.
world-path-or-wander = A thing moves along a 'path' or it wanders, not both. Remove 'path' or 'wander'.
# $kind is what has to be collected.
world-nothing-to-collect = The goal '{ $name }' asks to collect '{ $kind }', but the world has no such [[collectable]]. Add one, or remove the goal.
world-no-gates = The goal '{ $name }' asks to pass gates, but the world has no [[gate]]. Add one, or remove the goal.
# $robot is the name of a start, $team and $other are teams.
world-robot-in-two-teams = The robot '{ $robot }' is in the teams '{ $other }' and '{ $team }'. Leave it in one of them.
world-robot-twice = The team '{ $team }' has the robot '{ $robot }' twice. Remove one of them.
world-reach-choice = A goal has at most one of 'robot', 'object', 'together' and 'alone'.
world-line-shape = A line needs either 'points' (two or more) or 'start' and 'path'.
world-line-empty = A line needs a length, but this one ends where it starts.
world-line-open = The closed line '{ $name }' has to end where it starts, at ({ $start_x }, { $start_y }). It ends at ({ $x }, { $y }).
world-group-missing = A world of the group '{ $group }' has to contain what this group is about.
world-picture-outside = The floor picture '{ $picture }' has to be in the same folder as the world's file.
world-picture-missing = There is no floor picture '{ $picture }' in the folder of the world's file.
world-picture-too-large = The floor picture '{ $picture }' is larger than { $limit } MB.
world-picture-not-png = The floor picture '{ $picture }' is not a PNG picture. Save it as PNG.
world-picture-too-many-pixels = The floor picture '{ $picture }' has { $width } by { $height } pixels. Each side can be at most { $limit } pixels.
world-picture-damaged = The floor picture '{ $picture }' is damaged.
world-bad-name = A world cannot be called '{ $name }'. Use up to 40 letters, digits, hyphens, underscores and spaces.

# Worlds as files to share. $limit is in MB.
world-file-type = LearnBlock can't open this type of file as a world. Choose a .toml or .zip file.
world-file-too-large = A world can have at most { $limit } MB, with its floor picture.
world-zip-damaged = This .zip file is damaged. Export the world again.
world-zip-too-many = This .zip file has more than { $most } files. Export the world again, or choose another file.
world-zip-contents =
    { $count ->
        [0] There is no world in this .zip file. A world is a .toml file.
       *[other] There are { $count } .toml files in this .zip file. Import one world at a time.
    }

# Files of simulated robots.

world-disc-without-radius = A disc needs a 'radius'.
world-box-without-size = A box needs 'length' and 'width'.
# $place is the place of a sensor or a joint in the file, such as joint[1].
world-range-reversed = The 'minimum' of '{ $place }' is { $minimum }. It has to be less than its 'maximum', { $maximum }.
# $group is the list in the file.
world-key-taken =
    { $group ->
        [camera] Two cameras have the key '{ $key }'. Give each its own key.
        [joint] Two joints have the key '{ $key }'. Give each its own key.
        [led] Two LEDs have the slot '{ $key }'. Give each its own slot.
       *[ground] Two ground sensors have the side '{ $key }'. Give each its own side.
    }

# A run in a world.

world-no-room = The world '{ $world }' has no free floor for another robot.
world-no-variants = The world '{ $world }' has no variants. Add [vary] to its file, with at least one bound.
# $name is an object or a start.
world-no-room-to-vary = Variant { $variant } of the world '{ $world }' has no room for '{ $name }'. Reduce the bounds in [vary] of its file.
world-bad-variant = The variant has to be a whole number from 0, not '{ $variant }'.
world-robot-taken = The world already has a robot called '{ $name }'. Choose another name.
world-bad-pace = The pace has to be free, real or a positive number such as 5, not '{ $pace }'.
world-bad-seed = The seed has to be a whole number, not '{ $seed }'.
world-bad-start = The start has to be three numbers (x, y, heading), not '{ $start }'.
world-not-drawable = LearnBlock can draw a run only if its robot is simulated.
# AprilTags.
world-no-tag = There is no tag { $number }. The tags of the family 36h11 have the numbers 0 to { $last }.
# The title of a page with tags to print.
world-tag-sheet = LearnBlock tags
