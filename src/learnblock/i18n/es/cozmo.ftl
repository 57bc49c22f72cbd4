# Cozmo. $place es su dirección con su puerto.

cozmo-no-answer = Cozmo no responde en { $place }. ¿Está encendido y este ordenador está en su wifi?
cozmo-unknown-address = No se encuentra a Cozmo en '{ $address }'. Revisa la dirección en los ajustes del robot.
cozmo-silent = Cozmo no responde en { $place } desde hace { $seconds } segundos. ¿Sigue encendido y cerca, y no lo usa otro programa?
cozmo-not-ready = Cozmo ha respondido en { $place }, pero no estaba listo a tiempo. Si la wifi no va lenta, apaga Cozmo y enciéndelo otra vez.
cozmo-unknown-sound = Cozmo no tiene ningún sonido '{ $name }'. Para añadirlo, pon un archivo { $name }.wav en { $folder }.
cozmo-unknown-sound-like = Cozmo no tiene ningún sonido '{ $name }'. ¿Querías decir '{ $suggestion }'?
cozmo-bad-sound = No se puede reproducir { $file }. Usa un archivo WAV de 8 o 16 bits por muestra.
cozmo-bad-voice = espeak-ng no puede usar la voz '{ $voice }' ({ $reason }). Elige otra voz en los ajustes del robot.
cozmo-no-speech = espeak-ng no ha podido decir el texto ({ $reason }).
