# The dialog that chooses a robot, and finds, connects and tries a real one.

page-connect-title = Connect a robot
page-connect-menu = Connect a robot…
page-connect-which = Which robots
page-connect-simulated = Simulated
page-connect-real = Real robot

# Simulated robots.
page-connect-group-twins = In LearnBlock
page-connect-group-own = Your own
page-connect-group-simulators = In other simulators
page-connect-simulators-help = Start the simulator before you run a program.
page-connect-use = Use this robot
page-connect-use-named = Use this robot: { $robot }
page-connect-chosen = Your robot
# On the simulated robot of the same kind as the real one.
page-connect-twin = Twin of your robot

# The list of real robots.
page-connect-found = Found near you: { $count }
# In the robot's menu, before the robots that answer.
page-connect-near = Found near you
page-connect-before = Used before
page-connect-others = Not found
page-connect-connect = Connect
page-connect-save-connect = Save and connect
page-connect-connect-named = Connect { $robot }
page-connect-disconnect = Disconnect
page-connect-connected = Connected
page-connect-needs-add-on = Needs an add-on
# The licence of an add-on that is not free.
page-connect-licence-legoed = With LEGO's own package, which is not for commercial use
page-connect-install = Install
page-connect-install-named = Install what { $robot } needs
page-connect-installing = Installing…
page-connect-install-stop = Stop installing
page-connect-install-terminal = In a terminal:
page-connect-busy = In use by another page or a program
page-connect-looking = Looking for it…
page-connect-away = Not found
page-connect-help = Help me
page-connect-help-named = Help me find { $robot }
page-connect-hint = Is it switched on? Is it charged?
page-connect-address = Enter an address
page-connect-address-help = Where this computer finds the robot, and what is plugged into its ports. Save changes before you connect.
page-connect-way-wifi = Wi-Fi
page-connect-way-usb = USB
page-connect-way-bluetooth = Bluetooth
page-connect-way-computer = this computer
page-connect-charge = { $percent }%

# The connection to a robot.
page-connect-idle = Switch your robot on. As soon as it is found, connect to it with one click.
page-connect-state-connecting = Connecting to { $robot }…
page-connect-state-lost = Connection to { $robot } lost. Its motors stop.
page-connect-state-failed = Can't connect to { $robot }
page-connect-again = Try again
page-connect-name = Name of this { $robot }
page-connect-reading = Reading its sensors…
page-connect-signal-strong = Signal strong
page-connect-signal-weak = Signal weak
page-connect-heard = heard { $milliseconds } ms ago
# How long a question to the robot and its answer take together.
page-connect-answers = answers in { $milliseconds } ms
# How strong the robot's radio was when it was found; $signal is in dBm.
page-connect-strength = { $strength ->
        [good] good reception
        [fair] fair reception
       *[poor] poor reception: go nearer
    } ({ $signal } dBm when found)
page-connect-battery = Battery about { $percent }% ({ $volts } V)
page-connect-full = Battery { $percent }%
page-connect-test-wheels = Test wheels
page-connect-test-face = Test face
page-connect-test-lamps = Test lamps
page-connect-test-beep = Beep
page-connect-stop = Stop
page-connect-warning = Test wheels drives 50 mm forward and back. Put the robot on the floor.
page-connect-stop-works = Stop works at any time:
page-connect-values = Live values
page-connect-heading = Heading
page-connect-driving = Driving
page-connect-turning = Turning
# $key is the key of a joint.
page-connect-joint = { $key ->
    [CAMERA] Head
    [ARM] Arm
   *[other] { $key }
}

# Calibration.
page-connect-calibrate = Calibrate
page-connect-exact = This robot needs no calibration.
page-connect-calibrate-help = No two robots are the same. Let it drive and turn, measure how far it went, and LearnBlock corrects its settings.
page-connect-calibrate-warning = The robot needs 1 m of free floor. Mark where it starts.
page-connect-drive-distance = Drive 500 mm
page-connect-drive-angle = Turn 360°
page-connect-measured-distance = It drove
page-connect-measured-angle = It turned
page-connect-corrections = New settings
page-connect-setting = Setting
page-connect-before-correction = Now
page-connect-after-correction = New
page-connect-save-correction = Save new settings
page-connect-calibrated = Saved. The robot uses them from now on.
page-connect-back = Back

# Help with finding a robot. Each question is answered with yes, or with what to do (-do).
page-connect-help-step = Question { $step } of { $steps }
page-connect-help-yes = Yes, next
page-connect-help-looking = Looking for { $robot } all the time…
page-connect-help-found = { $robot } is here!
page-connect-help-end = { $robot } is still not found. Perhaps it has another address than usual.

page-connect-help-cozmo-on = Is Cozmo awake?
page-connect-help-cozmo-on-do = Put Cozmo on its charger. That switches it on: its face appears.
page-connect-help-cozmo-charged = Is Cozmo charged?
page-connect-help-cozmo-charged-do = If it falls asleep at once, leave it on the charger for half an hour.
page-connect-help-cozmo-wifi = Is this computer on Cozmo's Wi-Fi?
page-connect-help-cozmo-wifi-do = Raise and lower Cozmo's lift once. Its screen shows a network, Cozmo_ and six letters, and the password. Choose that network on this computer. The internet is away until you change back.
page-connect-help-cozmo-other = Is Cozmo free?
page-connect-help-cozmo-other-do = Close the Cozmo app on every phone, and other programs that use Cozmo. Only one can use it at a time.
page-connect-help-cozmo-again = Did you switch it off and on?
page-connect-help-cozmo-again-do = Hold the button on its back until its lights go out. Then put it on the charger again and connect this computer to its Wi-Fi.

page-connect-help-thymio-on = Is Thymio on?
page-connect-help-thymio-on-do = Touch the round button between the arrows for three seconds, until its lights glow.
page-connect-help-thymio-charged = Is Thymio charged?
page-connect-help-thymio-charged-do = Leave it on its cable for a while. The lamp beside the socket shows that it charges.
page-connect-help-thymio-cable = Is the cable or the dongle plugged in?
page-connect-help-thymio-cable-do = Plug Thymio's USB cable or its radio dongle into this computer. Some cables only charge: try another one.
page-connect-help-thymio-permission = May you use this computer's serial ports?
page-connect-help-thymio-permission-do = On Linux, run: sudo usermod -a -G dialout $USER. Then log in again. Other systems need nothing.
page-connect-help-thymio-other = Is Thymio free?
page-connect-help-thymio-other-do = Close other programs that use Thymio, such as Aseba Studio or Scratch. Thymio Suite itself may stay open.

page-connect-help-legoed-on = Is the Double Motor on?
page-connect-help-legoed-on-do = Press its button until its light blinks. Do the same with the Color Sensor, the Controller and the Single Motor, if you use them.
page-connect-help-legoed-charged = Are the devices charged?
page-connect-help-legoed-charged-do = If one goes off by itself, charge it by its USB cable.
page-connect-help-legoed-card = Do all devices have the same connection card?
page-connect-help-legoed-card-do = Hold one card to each device of your robot, one after the other. In a class, each group has a card of its own.
page-connect-help-legoed-bluetooth = Is this computer's Bluetooth on?
page-connect-help-legoed-bluetooth-do = Switch it on in the system's settings, and allow LearnBlock to use it. The devices are not paired there: remove them from the list if they are.
page-connect-help-legoed-other = Are the devices free?
page-connect-help-legoed-other-do = Close other programs that use them, such as LEGO's Coding Canvas, on every computer and tablet nearby. Only one can use them at a time.
page-connect-help-create3-on = Is Create 3 on?
page-connect-help-create3-on-do = Put it on its charging dock. The ring of lights around its button turns white when it is ready, after about a minute.
page-connect-help-create3-charged = Is Create 3 charged?
page-connect-help-create3-charged-do = If its ring glows red, leave it on its dock for a while.
page-connect-help-create3-mode = Is its Bluetooth on?
page-connect-help-create3-mode-do = Its own web page, which you reach over its Wi-Fi, says so. Bluetooth needs firmware G.4.1 or later.
page-connect-help-create3-bluetooth = Is this computer's Bluetooth on?
page-connect-help-create3-bluetooth-do = Switch it on in the system's settings, and allow LearnBlock to use it. Create 3 is not paired there: remove it from the list if it is.
page-connect-help-create3-other = Is Create 3 free?
page-connect-help-create3-other-do = Close other programs that use it, such as the iRobot Python Web Playground, on every computer and tablet nearby. Only one can use it at a time.
page-connect-help-root-on = Is Root on?
page-connect-help-root-on-do = Hold its yellow nose for four seconds, until its eyes light up.
page-connect-help-root-charged = Is Root charged, and off its cable?
page-connect-help-root-charged-do = If it flashes red, charge it by its USB cable. Take the cable out before you connect: Root does not while it charges.
page-connect-help-root-bluetooth = Is this computer's Bluetooth on?
page-connect-help-root-bluetooth-do = Switch it on in the system's settings, and allow LearnBlock to use it. Root is not paired there: remove it from the list if it is.
page-connect-help-root-other = Is Root free?
page-connect-help-root-other-do = Close other programs that use it, such as iRobot Coding, on every computer and tablet nearby. Only one can use it at a time.
page-connect-help-spike-on = Is the hub on?
page-connect-help-spike-on-do = Press its round button. A Bluetooth light blinks until something connects to it.
page-connect-help-spike-charged = Is the hub charged?
page-connect-help-spike-charged-do = If it goes off by itself, charge it by its USB cable.
page-connect-help-spike-pybricks = Does it run Pybricks?
page-connect-help-spike-pybricks-do = LEGO's own software has a dance of lights when it starts; Pybricks does not. Put Pybricks on it once, in a browser: code.pybricks.com, under Tools.
page-connect-help-spike-bluetooth = Is this computer's Bluetooth on?
page-connect-help-spike-bluetooth-do = Switch it on in the system's settings, and allow LearnBlock to use it. The hub is not paired there: remove it from the list if it is.
page-connect-help-spike-other = Is the hub free?
page-connect-help-spike-other-do = Close other programs that use it, such as Pybricks Code, on every computer and tablet nearby. Only one can use it at a time.

page-connect-help-ev3-on = Is the EV3 on?
page-connect-help-ev3-on-do = Press its middle button. It is ready when its lamp glows green, which takes up to two minutes with ev3dev.
page-connect-help-ev3-charged = Is the EV3 charged?
page-connect-help-ev3-charged-do = If its screen goes dark, charge its battery or put in new ones.
page-connect-help-ev3-system = Does it run ev3dev or LEGO's own software?
page-connect-help-ev3-system-do = With ev3dev, its screen shows "File Browser" at the top of the menu; without it, LEGO's software. Both work.
page-connect-help-ev3-network = Is it on the same network as this computer?
page-connect-help-ev3-network-do = Its screen shows an IP address at the top if it is. Otherwise connect it in its menu: Wireless and Networks, Wi-Fi. A USB or Bluetooth connection works, too.
page-connect-help-ev3-setup = Was the brick set up for LearnBlock?
page-connect-help-ev3-setup-do = With ev3dev, run once on this computer: learnblock robots setup ev3. After switching the brick on, start learnblock-agent.py in its file browser. LEGO's software needs nothing.

page-connect-help-ebo-on = Is EBO on?
page-connect-help-ebo-on-do = Switch it on and wait about a minute, until its face appears.
page-connect-help-ebo-charged = Is EBO charged?
page-connect-help-ebo-charged-do = If its screen stays dark, charge its battery.
page-connect-help-ebo-wifi = Is this computer on EBO's Wi-Fi?
page-connect-help-ebo-wifi-do = EBO makes its own network. Choose it on this computer. EBO then has the address 192.168.16.1.
page-connect-help-ebo-other = Is EBO free?
page-connect-help-ebo-other-do = Close other programs that drive EBO.
page-connect-help-ebo-again = Did you switch it off and on?
page-connect-help-ebo-again-do = Switch EBO off and on again, and wait for its face.

page-connect-help-rcis-started = Is RCIS running?
page-connect-help-rcis-started-do = Start RCIS with the world of your robot, and wait until its window shows the robot.
page-connect-help-rcis-computer = Is it on this computer?
page-connect-help-rcis-computer-do = If RCIS is on another computer, enter that computer's address.

page-connect-help-coppeliasim-started = Is CoppeliaSim running?
page-connect-help-coppeliasim-started-do = Start CoppeliaSim 4.6 or later, and open your scene.
page-connect-help-coppeliasim-service = Is its remote control on?
page-connect-help-coppeliasim-service-do = In CoppeliaSim, choose Modules, Connectivity, ZMQ remote API server.
page-connect-help-coppeliasim-other = Is it on this computer?
page-connect-help-coppeliasim-other-do = If it is on another computer, enter that computer's address.

page-connect-help-own-on = Is the robot on?
page-connect-help-own-on-do = Switch it on, and wait until it has started.
page-connect-help-own-charged = Is the robot charged?
page-connect-help-own-charged-do = Charge its battery, or put in new ones.
page-connect-help-own-network = Is it connected to this computer?
page-connect-help-own-network-do = Connect it by its cable or its network, as its maker describes.
page-connect-help-own-other = Is the robot free?
page-connect-help-own-other-do = Close other programs that use it.
