# A real robot, compared with its twin.

twin-none = A twin can be compared only with a real robot, and only if that robot has one. This log has no such run.
twin-needs-one = With --with-twin, compare takes one log.
twin-needs-two = Name two logs, or one log of a real robot and --with-twin.
twin-together = The robot went where its twin went: it was never more than 30 mm or 10° away from it.
twin-parted = At { $time } s the robot was { $distance } mm away from where its twin went with the same commands, near x = { $x } mm, y = { $y } mm.
twin-askew = At { $time } s the robot faced { $angle }° more to the { $side ->
    [right] right
   *[left] left
} than its twin with the same commands.
twin-drives = It drives { $percent } % too { $much ->
    [more] far
   *[less] little
}, by its { $sensor ->
    [distance] distance sensor
   *[odometry] own count
}.
twin-turns = It turns { $percent } % too { $much ->
    [more] far
   *[less] little
}, by its { $sensor ->
    [gyroscope] gyroscope
   *[odometry] own count
}.
twin-wheels = Its wheels turned { $percent } % { $much ->
    [more] more
   *[less] less
} than they were told: look for an empty battery, a speed too high for its motors, or something that holds a wheel.
twin-set = In the robot's settings, change { $setting } from { $now } to { $value }.
twin-no-setting = This robot has no setting for that: it controls its speed itself. Let the program measure instead, or change its speeds.
twin-sensor = The robot went where its twin went, but from { $time } s on its distance sensor measured { $real } mm instead of { $twin } mm: the sensor is wrong, or the world is not as drawn.

## What the log does not have.

twin-no-odometry = This robot does not report where it is, so its way is not known.
twin-way-not-measured = Its wheels count their turns, not the way: how far it really drove was not recorded. Measure it with a ruler (Calibrate), or drive straight towards a wall and choose that world.
twin-turn-not-measured = How far it really turned was not recorded: this robot has no gyroscope.
twin-empty-floor = Its twin drove on an empty floor: bumps, lines and what the sensors saw were not compared.
