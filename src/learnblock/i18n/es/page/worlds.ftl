# Los mundos como archivos: el menú en la cabecera del mundo.

page-worlds-import = Importar un mundo…
page-worlds-export = Descargar el mundo
page-worlds-variant-choose = Elegir una variante…
page-worlds-variant = Variante { $number }
page-worlds-variant-title = Variante del mundo
page-worlds-variant-number = Número
page-worlds-variant-help = 0 es el mundo tal como está dibujado. En cada otra variante cambian un poco la salida, los objetos, la luz y el ruido; la variante 7 es la misma en todos los ordenadores. Un buen programa alcanza su meta en todas.
page-worlds-variant-any = Cualquiera
page-worlds-variant-show = Mostrar
page-worlds-rename = Cambiar el nombre…
page-worlds-delete = Eliminar
page-worlds-rename-title = Cambiar el nombre del mundo
page-worlds-rename-help = Los proyectos y la línea de órdenes siguen conociendo este mundo como { $name }.
page-worlds-rename-now = Cambiar el nombre
page-worlds-deleted = { $title } está en la papelera.
page-worlds-restore = Restaurar
page-worlds-large-file = { $name } es demasiado grande. Copia su archivo .toml y su imagen en la carpeta 'worlds' de tu propia carpeta.
