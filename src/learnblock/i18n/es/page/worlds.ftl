# Los mundos como archivos: el menú en la cabecera del mundo.

page-worlds-menu = Menú del mundo
page-worlds-import = Importar un mundo…
page-worlds-export = Descargar el mundo
page-worlds-rename = Cambiar el nombre…
page-worlds-delete = Eliminar
page-worlds-rename-title = Cambiar el nombre del mundo
page-worlds-rename-help = Los proyectos y la línea de órdenes siguen conociendo este mundo como { $name }.
page-worlds-rename-now = Cambiar el nombre
page-worlds-deleted = { $title } está en la papelera.
page-worlds-restore = Restaurar
page-worlds-large-file = { $name } es demasiado grande. Copia su archivo .toml y su imagen en la carpeta 'worlds' de tu propia carpeta.
