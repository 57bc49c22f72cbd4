# A value that a program gave to a device, such as the speed of the wheels.
# $name is the parameter, $value the value as Python writes it.

device-not-number = '{ $name }' must be a number, not { $value }.
device-not-finite = '{ $name }' must be a finite number, not { $value }.
device-unknown-emotion = { $emotion } is not an emotion. Use one of these: { $known }.
device-unknown-emotion-like = { $emotion } is not an emotion. Did you mean '{ $suggestion }'?
device-unknown-color = { $color } is not a colour. Use one of these: { $known }; or red, green and blue as in "#ff8800".
