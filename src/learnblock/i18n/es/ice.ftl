# Componentes que usan el protocolo Ice: errores de la conexión y de los mensajes.

ice-timeout = El componente no ha respondido a tiempo.
ice-no-listener = Ningún componente escucha en esta dirección y este puerto.
ice-unknown-address = No hay ningún ordenador con este nombre. Revisa la dirección.
ice-hung-up = El componente ha cerrado la conexión.
ice-closed = La conexión con el componente está cerrada.
ice-broken = Se ha perdido la conexión con el componente ({ $reason }).
ice-unexpected-message = El componente ha enviado un mensaje inesperado ({ $kind }).
ice-garbled = El componente ha enviado un mensaje que no se puede leer. { $reason }
ice-no-operation = '{ $interface }' no tiene ninguna operación '{ $operation }'.
ice-wrong-interface = El componente no tiene la interfaz { $interface }.
ice-bad-proxy = '{ $text }' no es un proxy. Escríbelo así: base:tcp -h localhost -p 10004
ice-bad-value = { $value } no es un valor válido ({ $type }).
ice-value-count = { $expected ->
    [one] Se espera un valor, no { $given }.
   *[other] Se esperan { $expected } valores, no { $given }.
}
ice-too-short = El mensaje es demasiado corto: deberían seguir { $expected } bytes, pero solo siguen { $left }.
ice-too-long = El mensaje es demasiado largo: sobran { $left } bytes.
ice-unknown-encoding = No se admite la codificación { $version }.
ice-not-ice = Los datos no son un mensaje de Ice: { $start }
ice-compressed = El mensaje está comprimido, y eso no se admite.
ice-message-size = El mensaje tiene { $size } bytes; se admiten { $limit } como máximo.
