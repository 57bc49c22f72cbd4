# Bluetooth Low Energy. $robot is a robot's id, $place an address or a robot's id.

bluetooth-none = This computer has no Bluetooth. Plug in a Bluetooth adapter, or use another computer.
bluetooth-off = This computer's Bluetooth is off. Switch it on and try again.
bluetooth-denied = LearnBlock may not use this computer's Bluetooth. Allow it in the system's privacy settings and try again.
bluetooth-not-found = No robot '{ $robot }' was found over Bluetooth within { $seconds } seconds. Is it on, in range, and not in use by another program?
bluetooth-other-not-found = No robot '{ $address }' was found over Bluetooth within { $seconds } seconds. Is it on, in range, and not in use by another program? An empty address in the robot settings takes the first '{ $robot }'.
bluetooth-taken = The robot at { $place } is in use by another program. Close that program and try again.
bluetooth-lost = The robot at { $place } has ended the Bluetooth connection. Is it on and in range?
