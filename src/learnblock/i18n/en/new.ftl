# New robots, skills and worlds: their names, descriptions and files.

# $example is a similar name that is allowed.
new-bad-robot-name = A robot cannot be named '{ $name }'. Use at most { $most } lower-case letters, digits and -, such as { $example }.
new-bad-skill-name = A skill cannot be named '{ $name }'. Use at most { $most } lower-case letters, digits and _, such as { $example }.
new-twin-name = '{ $name }' is the name of a simulated robot. Leave out sim-, which is created as well.
new-robot-exists = There is already a robot '{ $name }'. Choose another name.
new-skill-exists = Every robot already has a '{ $name }'. Choose another name.
new-world-exists = There is already a world '{ $name }'. Choose another name.
# $files lists files.
new-files-exist = These files already exist: { $files }. Choose another name, or replace them with --force.

# A robot's description.
new-too-wide = The body reaches { $reach } mm from the middle between the wheels, but the worlds only have room for { $most } mm.
new-gyroscope-key = The key of a robot's gyroscope must be Z_AXIS, not { $key }.
new-bad-key = The { $field } '{ $key }' is not a word. Use letters, digits, spaces and _.

# The questions of: learnblock new robot
new-ask-name = Name of the robot, such as path-finder
new-ask-connection = Connection
new-ask-distance-count = Number of distance sensors
new-ask-distance-sensor = Distance sensor { $number }, from left to right:
new-ask-sides = distance.sides (where its reading appears)
new-ask-ground = Ground sensors (left, central, right, or none)
new-ask-ground-sensor = Ground sensor { $side }:
new-ask-gyroscope = Does it have a gyroscope?
new-ask-accelerometer = Does it have an accelerometer?
new-ask-face = Does it have a face that shows emotions?
new-ask-speaker = Does it have a loudspeaker?
new-ask-camera = Does it have a camera?
new-ask-joints = Joints, such as CAMERA, ARM (or none)
new-ask-joint = Joint { $joint }:
new-ask-range-order = Error: joint.minimum must be below joint.maximum.
new-ask-leds = Positions of its LEDs, such as Front, Left (or none)
new-ask-led-colour = { $position }: can it change colour?
# $allowed describes the values that are allowed.
new-ask-wrong-value = { $key } cannot be '{ $value }'. Expected { $allowed }.
new-ask-unknown = '{ $value }' is not one of { $known }.
new-ask-bad-key = '{ $key }' is not a word. Use letters, digits and spaces.
