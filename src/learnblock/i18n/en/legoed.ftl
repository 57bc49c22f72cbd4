# LEGO Education's devices. $place is an address or a robot's id.

legoed-not-found = No Double Motor was found over Bluetooth within { $seconds } seconds. Is it on, in range, and not in use by another program?
# $choice is an address, or a card such as "azure 3683".
legoed-other-not-found = No Double Motor '{ $choice }' was found over Bluetooth within { $seconds } seconds. Is it on, in range, and not in use by another program? The robot settings choose it.
legoed-several = { $number } Double Motors are nearby. Hold a connection card to yours, and choose the card in Connect or in the robot settings.
legoed-garbled = The device at { $place } does not behave like the expected device of LEGO Education. Check the addresses in the robot settings.
# $device and $package are versions, such as 2.3.0.
legoed-other-version = { $newer ->
        [true] The device at { $place } has newer software ({ $device }) than LEGO's Python package knows ({ $package }). Update the package: install the add-on again, with --upgrade.
       *[false] The device at { $place } has older software ({ $device }) than LEGO's Python package expects ({ $package }). Update the device at https://code.legoeducation.com.
    }
