# Los bloques propios: sus nombres, su código y su configuración.

custom-bad-name = Un bloque no se puede llamar '{ $name }'. Usa como mucho { $most } letras, cifras, espacios, - y _, y empieza por una letra o una cifra.
custom-device-name = Windows usa el nombre '{ $name }' para un dispositivo. Elige otro nombre.
custom-name-taken = Ya tienes un bloque '{ $name }'. Elige otro nombre o sustituye ese bloque.
custom-unreadable = No se puede leer el archivo: { $reason }

custom-file-too-large = El archivo es demasiado grande: el límite es { $limit } caracteres.
custom-not-exported = Esto no es un bloque exportado de LearnBlock: { $reason }
custom-file-version = Este bloque tiene el formato { $version }, pero este LearnBlock lee el formato { $known }. Actualiza LearnBlock.

custom-source-too-large = El código es demasiado largo: el límite es { $limit } caracteres.
custom-not-python = Esto no es Python válido: { $reason }
custom-no-function = Ninguna función recibe el robot como primer parámetro. Escribe una, por ejemplo 'def dance(robot, times: int = 3):'.
custom-async = '{ $name }' es async, y un bloque no puede serlo. Escribe 'def { $name }'.
custom-no-robot = '{ $name }' no es un bloque porque no recibe el robot. Pon 'robot' como primer parámetro, o llámala '_{ $name }' si solo ayuda a otras.
custom-first-parameter = El primer parámetro de '{ $name }' recibe el robot: llámalo 'robot' en vez de '{ $parameter }'. Los demás parámetros van detrás.
custom-duplicate-function = '{ $name }' también está definida en la línea { $line }, y solo se usa esta. Cambia el nombre de una de las dos.
custom-unfit-parameter = Un bloque no puede dar el parámetro '{ $parameter }' de '{ $name }'. Quita el *, o dale un valor por defecto.
custom-python-word = '{ $name }' significa '{ $plain }' en Block-Text. Elige otro nombre.
custom-bad-hint = Tipo de '{ $parameter }' en '{ $function }': { $problem }
custom-bad-default = El valor por defecto { $default } no encaja en '{ $parameter }' de '{ $function }'. { $expected }

custom-taken-by-block = Tu bloque '{ $block }' ya tiene una función '{ $name }'. Elige otro nombre.
custom-taken-by-library = La biblioteca '{ $library }' ya tiene una habilidad '{ $name }'. Elige otro nombre.
custom-taken-by-plugin = Un plugin ya tiene una habilidad '{ $name }'. Elige otro nombre.
custom-taken-by-robot = Todos los robots ya tienen '{ $name }'. Elige otro nombre.
custom-taken-by-skill = LearnBlock ya tiene una habilidad '{ $name }'. Elige otro nombre.

custom-stale-function = La configuración describe '{ $name }', pero no hay ninguna función así. Esa parte no se usa.
custom-stale-parameter = '{ $block }' no tiene el parámetro '{ $parameter }'. Esa parte de la configuración no se usa.
custom-stale-type = '{ $parameter }' de '{ $block }' es { $actual } en la función y { $chosen } en la configuración. Vale la función.
custom-stale-shape = '{ $block }' es { $kind ->
    [value] un valor
   *[statement] una instrucción
} en la función, pero no en la configuración. Vale la función.

custom-import-relative = Aquí un import no puede empezar con un punto, porque cada archivo de bloques va por separado. Importa paquetes por su nombre.
custom-import-package = import { $module }: el paquete '{ $package }' no está instalado. Revisa el nombre, o instálalo donde está instalado LearnBlock.
custom-import-library = import { $module }: la biblioteca '{ $library }' no está instalada. Importa antes su archivo.
custom-import-module = import { $module }: LearnBlock no tiene ese módulo.
custom-import-module-like = import { $module }: LearnBlock no tiene ese módulo. ¿Querías decir '{ $suggestion }'?
custom-import-name = { $module } no tiene '{ $name }'.
custom-import-name-like = { $module } no tiene '{ $name }'. ¿Querías decir '{ $suggestion }'?
