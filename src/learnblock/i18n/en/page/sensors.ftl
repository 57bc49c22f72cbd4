# Values and plot of the sensors.

page-sensors-title = Robot sensors
page-sensors-readings = Live values (tick to plot)
page-sensors-nothing = No sensor values yet. Run a program or drive the robot.
page-sensors-save = Save as CSV
page-sensors-plot = Plot of the last minute: { $sensors }
page-sensors-summary = Last minute in numbers
page-sensors-sensor = Sensor
page-sensors-lowest = Lowest
page-sensors-highest = Highest
page-sensors-mean = Mean
page-sensors-time = Time
page-sensors-yes = yes
page-sensors-no = no
# $device is the type of the device, $place a side, an axis or a button ("none" without one), and
# $number counts the sensors of one place from 1 (0 for the only one).
page-sensors-name = { $device ->
    [DistanceSensors] Distance
    [GroundSensors] Ground
    [Gyroscope] Gyroscope
    [Accelerometer] Accelerometer
    [Bumper] Bumper
    [LightSensor] Light
    [Controller] Button
    [Infrared] Infrared
    [Heading] Heading
    [Driven] Distance driven
   *[other] { $device }
}{ $place ->
    [none] {""}
    [front] {" in front"}
    [back] {" behind"}
    [left] { $device ->
        [Accelerometer] {" to the left"}
       *[other] {" on the left"}
    }
    [right] {" on the right"}
    [central] {" in the middle"}
    [forward] {" forward"}
    [up] {" up"}
   *[other] {" "}{ $place }
}{ $number ->
    [0] {""}
   *[other] {" "}{ $number }
}
# $device is the type of the device that measures, $place the side of a distance sensor.
page-sensors-measure = { $device ->
    [DistanceSensors] { $place ->
        [front] Front
        [left] Left
        [right] Right
       *[back] Behind
    }
    [GroundSensors] Floor
    [Bumper] Bumper
    [Accelerometer] Acceleration
    [LightSensor] Light
    [Controller] Buttons
    [Infrared] Infrared
    [Camera] Camera
    [Heading] Heading
    [Driven] Driven
   *[other] { $device }
}
