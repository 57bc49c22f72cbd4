# LEGO SPIKE with Pybricks. $place is an address or a robot's id.

spike-too-old = The Pybricks firmware of the hub at { $place } is too old (protocol { $version }). Update it at https://code.pybricks.com.
spike-garbled = The device at { $place } does not behave like a hub with Pybricks. Check the address in the robot settings.
spike-not-started = LearnBlock's program did not start on the hub at { $place }. Switch the hub off and on, and try again.
spike-agent-ended = LearnBlock's program on the hub at { $place } has ended: the hub's button was pressed, or it heard nothing for 1.5 seconds. Run the program again.
# $motor is left or right, $port a letter.
spike-no-motor = The hub has no { $motor ->
        [left] left
       *[other] right
    } motor. Plug it in at any port.
spike-no-motor-at = The hub has no { $motor ->
        [left] left
       *[other] right
    } motor at port { $port }. Plug it in, or change the port in the robot settings.
spike-motor-lost = The { $motor ->
        [left] left
       *[other] right
    } motor of the hub no longer answers. Is its cable plugged in?
spike-no-sensor = The hub has no { $sensor ->
        [distance] distance sensor
        [colour] colour sensor
       *[force] force sensor
    } at port { $port }. Plug it in, or change the port in the robot settings.
spike-sensor-lost = The { $sensor ->
        [distance] distance sensor
        [colour] colour sensor
       *[force] force sensor
    } of the hub no longer answers. Is its cable plugged in?
