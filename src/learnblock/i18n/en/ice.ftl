# Components that use the Ice protocol: errors of the connection and of the messages.

ice-timeout = The component did not answer in time.
ice-no-listener = No component is listening at this address and port.
ice-unknown-address = There is no computer with this name. Check the address.
ice-hung-up = The component closed the connection.
ice-closed = The connection to the component is closed.
# $reason is a message of the operating system.
ice-broken = The connection to the component was lost ({ $reason }).
ice-unexpected-message = The component sent an unexpected message ({ $kind }).
# $reason is another phrase of this file.
ice-garbled = The component sent a message that can't be read. { $reason }
ice-no-operation = '{ $interface }' has no operation '{ $operation }'.
ice-wrong-interface = The component does not have the interface { $interface }.
ice-bad-proxy = '{ $text }' is not a proxy. Write it like this: base:tcp -h localhost -p 10004
ice-bad-value = { $value } is not a valid { $type }.
ice-value-count = { $expected ->
    [one] One value is expected, not { $given }.
   *[other] { $expected } values are expected, not { $given }.
}
ice-too-short = The message is too short: { $expected } bytes should follow, but only { $left } do.
ice-too-long = The message is too long: { $left } bytes are left over.
ice-unknown-encoding = The encoding { $version } is not supported.
ice-not-ice = The data is not an Ice message: { $start }
ice-compressed = The message is compressed, which is not supported.
ice-message-size = The message has { $size } bytes; at most { $limit } are allowed.
