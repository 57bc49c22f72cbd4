# Cozmo. $place is its address with its port.

cozmo-no-answer = Can't reach Cozmo at { $place }. Is it on, and is this computer on its Wi-Fi?
cozmo-unknown-address = Cozmo not found at '{ $address }'. Check the address in the robot settings.
cozmo-silent = Cozmo at { $place } has not answered for { $seconds } seconds. Is it still on and in range, and is no other program using it?
cozmo-not-ready = Cozmo at { $place } answered but did not get ready in time. If the Wi-Fi is not slow, switch Cozmo off and on again.
cozmo-unknown-sound = Cozmo has no sound '{ $name }'. To add it, put a file { $name }.wav into { $folder }.
cozmo-unknown-sound-like = Cozmo has no sound '{ $name }'. Did you mean '{ $suggestion }'?
cozmo-bad-sound = { $file } can't be played. Use a WAV file with 8 or 16 bits per sample.
# espeak-ng is the program that speaks; $reason is its own message.
cozmo-bad-voice = espeak-ng can't use the voice '{ $voice }' ({ $reason }). Choose another voice in the robot settings.
cozmo-no-speech = espeak-ng could not speak the text ({ $reason }).
