# Robots of any kind: their class, their devices and skills, their settings.

# $device is the type of device in the programming interface, such as Base.
robot-key-taken = This robot already has a device of type { $device } with the key '{ $key }'. Give the second one a different key.
# Messages between robots.
robot-message-name = The name of a message is a text of 1 to { $limit } characters, such as "go".
robot-message-value = A message can't carry this value ({ $type }). Send a number, a text, true or false, or a list or dictionary of these.
robot-message-too-large = The value of the message '{ $message }' has { $size } bytes, but a message can carry at most { $limit }. Send less at once.
robot-stopped = The robot has been stopped, so it can't be used any more. Run the program again.
# The program asked for a sense or a device, which the check could not know. $device: from check-device
robot-lacks = This robot has no { $device }, which this part of the program needs.
robot-lacks-for-skill = This robot has no { $device }: it can't do '{ $skill }'.
robot-skill-name-taken = A skill can't be called '{ $name }', because every robot already has that name. Choose another name.
robot-unknown-skill = This robot has no skill '{ $name }'.
robot-unknown-skill-like = { robot-unknown-skill } Did you mean '{ $suggestion }'?

# The class of a robot. $module is the module's name in Python.
robot-no-class = The robot's file { $module } needs a class 'Robot' that inherits from 'Client'.
# $reason is the error of the robot's file, in English.
robot-not-loaded = The robot '{ $name }' can't be loaded ({ $reason }).
# The guardian of a robot without a watchdog.
robot-computer-froze = This computer was frozen or too busy for half a second, so the motors of '{ $robot }' were stopped. Close other programs if this happens often, and run the program again.
robot-guardian-ended = The process that stops '{ $robot }' in an emergency has ended, so the robot can't be driven safely. Run the program again.
# The link of a robot whose library is asynchronous. $reason is the library's error, in English.
robot-link-silent = The robot at { $place } stopped answering. Is it on and in range?
robot-link-broke = The connection to the robot at { $place } was lost ({ $reason }). Is it on and in range?
robot-link-closed = The connection to the robot at { $place } is closed. Run the program again.
robot-needs-no-setup = The robot '{ $name }' needs no setup.
robot-missing-add-on = The robot '{ $robot }' needs an add-on that is not installed. Install it with: { $command }
robot-missing-package = The robot '{ $robot }' needs the Python package { $package }. Install it where LearnBlock is installed.
# A function that the author of a new robot has to write; $task is its docstring.
robot-not-written = { $file }, line { $line }: '{ $call }' still has to be written. { $task }

# The components of EBO and RCIS. $place is an address with a port.
robot-part-unreachable = { $robot ->
    [rcis] Can't reach the { $part ->
        [base] wheels
        [joint] camera tilt
        [laser] distance sensors
        [face] face
        [screen] screen
       *[camera] camera
    } in RCIS at { $place }. Is RCIS running, with all its components?
   *[ebo] Can't reach EBO's { $part ->
        [base] wheels
        [joint] camera tilt
        [laser] distance sensors
        [face] face
        [screen] screen
       *[camera] camera
    } at { $place }. Is EBO on, and is this computer on its Wi-Fi?
}
robot-part-layout = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} at { $place } uses a different message layout. Choose another 'layout' in the robot settings.
# $reason is the component's own message.
robot-part-refused = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} at { $place } can't do that ({ $reason }).
robot-unknown-layout = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} at { $address } uses a message layout that LearnBlock doesn't know. Update its components or LearnBlock.

# What a setting means, shown below its field and on the command line.
robot-setting-patience = timeout in seconds
robot-setting-address = host name or IP address
robot-setting-port = network port
robot-setting-serial-port = serial port, such as /dev/ttyUSB0 or COM3
robot-setting-baud = bits per second
robot-setting-length = mm
robot-setting-speed = mm/s
robot-setting-voice = espeak-ng voice
robot-setting-colour = colour pictures at half the width; otherwise grey
robot-setting-stop-at-cliff = stop where the floor ends
robot-setting-volume = volume in percent
robot-setting-camera-port = network port; 0 for no camera
robot-setting-layout = message layout of the components; auto detects it
robot-setting-connection = agent or rpyc on ev3dev, direct for LEGO's firmware; auto tries them in turn
robot-setting-device = LEGO's firmware by USB or Bluetooth: a device such as /dev/hidraw0
robot-setting-token = secret shared with the agent, created by setup
robot-setting-user = user name on ev3dev
robot-setting-password = password of that user
robot-setting-full-speed = wheel motor speed at 100 %, in degrees/s
robot-setting-legoed-card = the connection card of the robot's devices, such as azure 3683; empty for the only Double Motor nearby
robot-setting-legoed-address = the Double Motor's Bluetooth address; empty to find it by its card
robot-setting-legoed-device = the device's Bluetooth address; empty for the one with the same card, none for no such device
robot-setting-legoed-front = the end of the Double Motor that is the robot's front, by its own forward
robot-setting-irobot-address = the robot's name or Bluetooth address; empty for the first one found
robot-setting-spike-address = the hub's name or Bluetooth address; empty for the first hub found
robot-setting-thymio-connection = auto uses Thymio Suite if it is running, else a cable, else tcp
robot-setting-thymio-device = serial port; empty for the first Thymio found
robot-setting-track = distance between the wheels in mm
robot-setting-speed-unit = wheel speed at motor speed 1, in mm/s
robot-setting-name = what you call this robot
robot-setting-scene = LearnBlock's script, the paper's scene, or a robot by the names of its parts
robot-setting-script = object with the script; empty for the default
robot-setting-object = path of an object in the scene, such as /Robot/sonar
robot-setting-sensors = distance sensors, from left to right
