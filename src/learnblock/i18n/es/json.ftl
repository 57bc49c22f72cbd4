# Block configurations in JSON that cannot be read.

json-too-large = El archivo tiene { $size } caracteres, pero el límite es { $limit }. Divídelo en varios archivos.
json-empty = El archivo está vacío. Debe contener un bloque o una lista de bloques.
json-too-deep = Hay más de { $limit } paréntesis unos dentro de otros. Ningún bloque necesita tantos.
json-extra-comma = Quita esta coma antes de { $bracket }.
json-not-a-number = { $text } no es un número que un bloque pueda usar.
json-too-many-digits = Un número tiene más cifras de las que un bloque puede usar.
json-half-character = { $text } contiene un carácter incompleto: a \ud8.. le falta su segunda mitad.
json-text-over-lines = Este texto sigue en la línea siguiente. ¿Falta su " de cierre?
json-missing-comma = Falta una coma o un paréntesis de cierre antes de esto.
json-missing-colon = Faltan aquí los dos puntos, entre una clave y su valor.
json-missing-key = Falta aquí una clave entre comillas dobles.
json-missing-value = Falta aquí un valor: un texto entre comillas dobles, un número, true, false, null, una lista o un objeto.
json-missing-quote = A este texto le falta su " de cierre.
json-several-values = La configuración termina antes de esto. Escribe varios bloques como una lista.
json-backslash = Aquí no puede haber una sola \. Una barra invertida se escribe \\.
json-unicode-escape = Faltan cuatro cifras hexadecimales después de \u.
json-broken = Esto no es JSON válido: { $reason }.
