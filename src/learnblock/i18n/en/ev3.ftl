# LEGO's EV3. $place is its address with a port, or a device of this computer.

ev3-not-found = EV3 not found at { $address }. Is it on, and is this computer on the same network?
ev3-no-answer = No EV3 answers at { $place }. Is it on, and is this computer on the same network?
ev3-not-agent = The program at { $place } is not LearnBlock's agent. Run: learnblock robots setup ev3
ev3-not-rpyc = The program at { $place } is not an rpyc server. Choose another 'connection' in the robot settings.
ev3-rpyc-failed = The EV3 at { $place } can't be driven over rpyc ({ $reason }). Run 'learnblock robots setup ev3' to put LearnBlock's agent on it.
ev3-not-firmware = The program at { $place } is not LEGO's firmware. Choose another 'connection' in the robot settings.
ev3-firmware-silent = LEGO's firmware is not responding at { $place }. It serves one program at a time, so close any other program that uses the EV3.
ev3-device-silent = { $place } does not respond like an EV3. Is the EV3 on, and is this the right device?
ev3-no-device-files = This computer can reach LEGO's firmware only over Wi-Fi. Leave 'device' empty in the robot settings.
# $reason is a message of the operating system.
ev3-device-closed = The device { $device } can't be opened ({ $reason }). Is the EV3 connected?
ev3-taken = The EV3 at { $place } is in use by another program, or was until a moment ago. Close the other program and try again.
ev3-unknown-token = The EV3 at { $place } does not know this computer's token. Run: learnblock robots setup ev3
ev3-no-speech = The EV3 at { $place } can't speak with LEGO's firmware. Use ev3dev for speech.
ev3-no-motor = The EV3 at { $place } has no motor at port { $port }. Plug it in, or change the port in the robot settings.
ev3-no-sensor = The EV3 at { $place } has no { $sensor ->
        [ultrasonic] ultrasonic sensor
        [colour] colour sensor
        [gyroscope] gyroscope
        [touch] touch sensor
       *[other] sensor
    } at port { $port }. Plug it in, or change the port in the robot settings.
ev3-sensor-lost = The { $sensor ->
        [ultrasonic] ultrasonic sensor
        [colour] colour sensor
        [gyroscope] gyroscope
        [touch] touch sensor
       *[other] sensor
    } of the EV3 no longer answers. Is its cable plugged in?
ev3-motor-lost = A motor of the EV3 at { $place } no longer answers. Is its cable plugged in?
ev3-command-refused = The EV3 at { $place } refused a command. Switch it off and on again, and run the program again.
ev3-timed-out = The EV3 at { $place } stopped because it heard nothing from the program. Run the program again.
ev3-not-understood = The EV3 at { $place } did not understand a command. Run: learnblock robots setup ev3
# $reason is a message of an older agent on the brick, in English.
ev3-complaint = The EV3 at { $place } reported: { $reason }
ev3-closed = The connection to the EV3 at { $place } is closed. Run the program again.
ev3-silent = The EV3 at { $place } stopped answering. Is it on and in range?
ev3-link-broke = The connection to the EV3 at { $place } was lost. Is it on and in range?
ev3-garbled = The device at { $place } does not seem to be an EV3. Check the address and the port in the robot settings.

# learnblock robots setup ev3: what it is doing, and what went wrong.
ev3-setup-login = Logging in to { $address } as { $user }...
ev3-setup-copy = Copying LearnBlock's agent to the EV3...
ev3-setup-start = Starting the agent...
ev3-setup-done = The agent is running, and programs for the robot 'ev3' can use it. After switching the EV3 off and on, choose { $file } in its file browser or run this command again.
ev3-setup-other-brick = The EV3 at { $place } is not the one that was set up before. If it was replaced or reinstalled, delete its line in { $file }.
ev3-setup-no-login = The EV3 at { $place } does not accept the password of '{ $user }'. Change it with: learnblock robots set ev3 password
ev3-setup-broke = The EV3 at { $place } ended the connection ({ $reason }). Run the command again.
# $output is what the agent printed on the brick.
ev3-setup-not-started = The agent did not start on the EV3: { $output }
