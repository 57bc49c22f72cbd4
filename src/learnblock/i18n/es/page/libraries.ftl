# Bibliotecas de habilidades.

page-libraries-title = Bibliotecas
page-libraries-menu = Bibliotecas…
page-libraries-help = Una biblioteca añade bloques hechos por otras personas. Tienen su propia pestaña en la paleta.
page-libraries-none = Aún no hay bibliotecas instaladas.
page-libraries-import = Importar archivos…
page-libraries-import-now = Importar
page-libraries-more = Más archivos…
page-libraries-make = Crear una biblioteca…
page-libraries-use = Usar
page-libraries-use-one = Usar { $name } en este programa
page-libraries-used = El programa importa ahora { $name }.
page-libraries-download = Descargar { $name }
page-libraries-remove = Quitar { $name }
page-libraries-remove-now = Quitar
page-libraries-keep = Conservar
page-libraries-really-remove = ¿Quitar { $name }? Los programas que la importan dejarán de funcionar.
page-libraries-removed = { $name } se ha quitado.
page-libraries-imported = Importado: { $names }.
page-libraries-made = Se ha creado { $filename }.
page-libraries-wrong-file = { $name } no es una biblioteca. Elige un archivo .lblib de 1 MB como mucho.
# $name is NAME.conf or NAME.py, and $needed is NAME.lb.
page-libraries-part = { $name } es solo una parte de una biblioteca. Elige también { $needed }.
page-libraries-too-many = { $most ->
    [one] Puedes importar 1 biblioteca cada vez.
   *[other] Puedes importar como mucho { $most } bibliotecas a la vez.
    }
page-libraries-nothing-runs = Nada de una biblioteca se ejecuta hasta que la use un programa tuyo.
page-libraries-installed = Ya está instalada la versión { $version }, que es la misma o más nueva.
page-libraries-replace = Reemplazar { $names }
page-libraries-leave-out = Omitir { $name }
page-libraries-clash = El nombre { $skill } ya está en uso: { $place }.
page-libraries-new-name = Nombre nuevo para { $skill }
page-libraries-make-help = Elige lo que podrán usar los demás. Cada función incluye las que llama.
page-libraries-name = Nombre
page-libraries-name-help = Minúsculas, cifras y _. Los programas importan la biblioteca con este nombre.
page-libraries-version = Versión (la más alta es la más nueva)
page-libraries-version-help = Por ejemplo, 1.0.0
page-libraries-label = Nombre de la pestaña
page-libraries-label-help = Si se deja vacío, el de la biblioteca
page-libraries-functions = Funciones de este programa
page-libraries-no-functions = Este programa no tiene funciones.
page-libraries-own = Mis bloques
page-libraries-along = incluye { $names }
page-libraries-make-now = Crear y descargar
