# Thymio. $place is an address with a port, or a serial port.

thymio-not-plugged-in = No Thymio is plugged in. Connect its cable or its dongle and switch it on, or choose its port in the robot settings.
thymio-no-listener = No program for a Thymio answers at { $place }. Start asebaswitch or Aseba's playground there, or correct the address and the port in the robot settings.
thymio-no-suite = Thymio Suite does not answer at { $place }. Start it, or choose another connection in the robot settings.
thymio-not-found = There is no Thymio at this computer. Switch it on and connect its cable or its dongle, or start Thymio Suite. At { $place }, where asebaswitch would be, nothing answers either.
# $reason is a message of the operating system.
thymio-port-closed = The Thymio at { $place } can't be opened ({ $reason }). Is it plugged in, and not in use by another program such as Thymio Suite?
thymio-no-answer = No Thymio answers at { $place }. Check that it is switched on and that no other program is using it.
thymio-not-ready = The Thymio at { $place } answered, but was not ready in time. Switch it off and on, and close other programs that use it.
thymio-other-robot = The robot at { $place } is not a Thymio but '{ $name }'. Change the connection in the robot settings.
thymio-too-old = The firmware of the Thymio at { $place } is too old. Update it with Thymio Suite.
thymio-suite-empty = Thymio Suite at { $place } shows no Thymio. Is the robot on and connected?
thymio-suite-busy = Thymio Suite at { $place } has no free Thymio. Is the robot on, and not in use by another program?
thymio-suite-silent = Thymio Suite is not responding at { $place }. Restart it, and close other programs that use the Thymio.
# $code is Thymio Suite's own number for the error.
thymio-suite-refused = Thymio Suite at { $place } refused the program (error { $code }). Close other programs that use the Thymio.
thymio-silent = The Thymio at { $place } has not answered for { $seconds } seconds. Is it on and in range, and not in use by another program?
thymio-garbled = The data from { $place } does not come from a Thymio. Change the connection in the robot settings.
thymio-taken = Another program is now using the Thymio at { $place }. Close it and run the program again.
thymio-link-broke = The connection to the Thymio at { $place } was lost ({ $reason }). Is it on and in range, and not in use by another program?
thymio-unknown-sound = A Thymio has no sound '{ $name }'. Use one of these, or the number of a file on its memory card: { $known }.
thymio-unknown-sound-like = A Thymio has no sound '{ $name }'. Did you mean '{ $suggestion }'?
