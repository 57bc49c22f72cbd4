# Archivos que una persona ha escrito o elegido.

# Un valor que un archivo no puede contener: $place es su lugar en el archivo, $reason una frase.
file-wrong-value = { $place }: { $reason }
file-too-many-statements = El archivo tiene { $count } funciones y otras instrucciones; el límite es { $limit }. Divídelo en varios archivos.
file-too-large = { $name } es demasiado grande: el límite es { $limit } MB.
file-quota = Tu carpeta está llena: caben { $most } MB. Elimina ejecuciones, proyectos u otros archivos que no necesites.
file-too-many-bytes = El archivo tiene { $size } bytes, pero puede tener como máximo { $limit }.
file-not-utf-8 = El byte { $position } del archivo no es UTF-8. Guarda el archivo como UTF-8.
file-not-python = Esto no es Python válido: { $reason }.

file-itself = el archivo
file-place = '{ $path }'

file-unknown-key = Clave desconocida en { $place }: '{ $key }'.
file-unknown-key-of = { file-unknown-key } Claves conocidas: { $known }.
file-unknown-key-like = { file-unknown-key } ¿Querías decir '{ $suggestion }'?
file-missing-key = Falta la clave '{ $key }' en { $place }.

file-at-line = Línea { $line }: { $problem }
file-mistakes = { $first } { $rest }
file-more-mistakes = { $count ->
    [one] Hay un error más.
   *[other] Hay { $count } errores más.
}

# Lo que se rechaza de un zip o de una carpeta; $file está dentro.
file-link = '{ $file }' es un enlace. Sustitúyelo por el archivo.
file-zip-outside = El archivo '{ $file }' quedaría fuera de la carpeta de su zip.
file-zip-encrypted = '{ $file }' está cifrado o comprimido de una forma desconocida.
file-zip-two = Hay dos archivos llamados '{ $file }'.
file-zip-bomb = '{ $file }' está más comprimido que cualquier archivo hecho por una persona.
