# Un valor que un programa ha dado a un dispositivo, como la velocidad de las ruedas.
# $name es el parámetro, $value el valor como lo escribe Python.

device-not-number = '{ $name }' tiene que ser un número, no { $value }.
device-not-finite = '{ $name }' tiene que ser un número finito, no { $value }.
device-unknown-emotion = { $emotion } no es una emoción. Usa una de estas: { $known }.
device-unknown-emotion-like = { $emotion } no es una emoción. ¿Querías decir '{ $suggestion }'?
device-unknown-color = { $color } no es un color. Usa uno de estos: { $known }; o rojo, verde y azul como en "#ff8800".
