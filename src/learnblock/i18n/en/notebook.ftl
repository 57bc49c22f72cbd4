# Robots in notebooks.

# $call is a method of the robot, such as show.
notebook-none = 'robot.{ $call }' works in a notebook, and this program runs in none. Run it in Jupyter or in VS Code's notebooks.
# $world is the name of a world.
notebook-new-world = This robot is in a new world ('{ $world }'). Earlier robots stay in theirs.
# $robot is the name of a robot, such as ev3.
notebook-disconnected = The earlier connection to '{ $robot }' was closed, since a robot has only one.
# A line of a cell, in "line 4 of [2] says ...". $cell is the number of the cell.
notebook-line = { $line } of [{ $cell }]
# The first cell with a robot has run before LearnBlock could note its steps.
notebook-not-noted = LearnBlock notes what cells do from the one after the first Robot() on. To ask about that one too, run '%load_ext learnblock.notebook' in a cell before it.
# The title of a page that shows the run of a cell. $cell is its number.
notebook-cell = Cell [{ $cell }]
