# Las bibliotecas de habilidades: sus archivos, sus nombres y su instalación.

library-not-found = Aquí no hay ninguna biblioteca. Indica un archivo que acabe en { $ending }, o una carpeta con un { $manifest }.
library-not-downloaded = LearnBlock no descarga bibliotecas. Descárgala tú, mírala e importa el archivo.
library-file-too-large = El archivo es demasiado grande: el límite es { $limit } bytes.
library-too-large = La biblioteca es demasiado grande: el límite es { $limit } bytes.
library-too-many-files = Una biblioteca puede tener como mucho { $most } archivos.
library-limits = Una biblioteca puede tener como mucho { $most } archivos con { $limit } bytes en total.
library-not-plain-file = { $file } no es un archivo normal. Quítalo de la biblioteca.
library-not-zip = Este archivo está dañado o no es una biblioteca.
library-file-outside = El archivo '{ $file }' quedaría fuera de la biblioteca.
library-unknown-file = Una biblioteca solo puede tener los archivos { $known } y archivos de Python con nombres en minúsculas.
library-not-utf-8 = Este archivo no es UTF-8. Guárdalo como UTF-8.
library-no-manifest = Esto no es una biblioteca: le falta { $manifest }.

library-two-skills = La habilidad '{ $skill }' también está en { $file }. Deja una de las dos.
library-no-skill = Esta biblioteca no tiene habilidades. Escribe una función cuyo primer parámetro sea 'robot'.
library-other-statement = Una biblioteca solo puede tener funciones y las variables que comparten.
library-python-name = '{ $name }' no puede ser el nombre de una habilidad, porque lo usa Python. Cámbialo.
library-functions-in-package = Cuando una biblioteca tiene varios archivos, LearnBlock genera { $file }. Pasa sus funciones a otro archivo.
library-first-parameter = En una biblioteca, el primer parámetro de '{ $function }' tiene que ser 'robot'.
library-foreign-skill = '{ $function }' usa function.{ $skill }, que no está en la biblioteca. Añade ese bloque a la biblioteca.
library-bad-name = Una biblioteca no se puede llamar '{ $name }'. Elige otro nombre.

library-unusual-name = '{ $name }' está escrito aquí de una forma rara. Cámbialo a mano.
library-name-used = '{ $name }' ya se usa aquí. Elige otro nombre.
library-two-meanings = '{ $name }' tiene aquí también otro significado. Cámbialo a mano.
library-skill-exists = La biblioteca ya tiene una habilidad '{ $skill }'. Elige otro nombre.
library-bad-skill-name = '{ $name }' no puede ser el nombre de una habilidad. Usa letras, cifras y _.

library-clash = La habilidad '{ $skill }' de la biblioteca { $library } ya existe en { $place }. Cámbiale el nombre con --rename { $skill }=NUEVO.
library-place-library = la biblioteca { $library }
library-place-block = tu bloque propio { $block }
library-place-plugin = un plugin
library-place-learnblock = LearnBlock
library-place-robot = todos los robots

library-two-names = library.toml tiene el nombre { $name }, pero la carpeta se llama { $folder }.
library-same-name = Dos de estas bibliotecas tienen el mismo nombre. Importa solo una.
library-not-newer = Está instalada la versión { $installed } de la biblioteca { $library }, y { $version } no es más nueva. Añade --replace para instalarla igualmente.
library-broken-file = { $file }: { $problem }
