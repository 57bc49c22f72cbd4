# Cozmo. $place is its address with its port.

cozmo-no-answer = Can't reach Cozmo at { $place }. Is it on, and is this computer on its Wi-Fi?
cozmo-unknown-address = Cozmo not found at '{ $address }'. Check the address in the robot settings.
cozmo-silent = Cozmo at { $place } has not answered for { $seconds } seconds. Is it still on and in range, and not in use by another program?
cozmo-not-ready = Cozmo at { $place } answered, but was not ready in time. Unless the Wi-Fi is slow, switch Cozmo off and on again.
cozmo-unknown-sound = Cozmo has no sound '{ $name }'. To add it, put a file named { $name }.wav in { $folder }.
cozmo-unknown-sound-like = Cozmo has no sound '{ $name }'. Did you mean '{ $suggestion }'?
cozmo-bad-sound = { $file } can't be played. Use a WAV file with 8 or 16 bits per sample.
# espeak-ng is the program that speaks; $reason is its own message.
cozmo-bad-voice = espeak-ng can't use the voice '{ $voice }' ({ $reason }). Choose another voice in the robot settings.
cozmo-no-speech = espeak-ng could not speak the text ({ $reason }).
