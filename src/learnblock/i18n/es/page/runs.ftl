# Las ejecuciones guardadas de un proyecto. $name es el nombre de una ejecución, o su fecha.

page-runs-none = El programa aún no se ha ejecutado. Aquí se guardan sus últimas 20 ejecuciones, y aquellas a las que pongas nombre.
page-runs-open-file = Abrir una ejecución de un archivo
page-runs-name-of = Poner nombre a { $name }
page-runs-delete-of = Borrar { $name }
page-runs-name = Poner nombre a esta ejecución
page-runs-name-help = Una ejecución con nombre se guarda hasta que la borres.
page-runs-name-now = Poner nombre
page-runs-download = Descargar { $name }
page-runs-restore = Volver a usar su programa
page-runs-delete = Borrar ejecución
page-runs-delete-named = ¿Borrar { $name }?
page-runs-delete-help = La ejecución no se puede recuperar.
page-runs-damaged = Este archivo está dañado y no se puede abrir.
page-runs-cut-off = Interrumpida
page-runs-foreign = de un archivo
page-runs-wrong-file = { $name } no es una ejecución. Elige un archivo { $ending }.
page-runs-large-file = { $name } es demasiado grande para una ejecución.
page-runs-not-sent = No se pudo abrir { $name }: LearnBlock no responde.
page-runs-shown = Ejecución mostrada: { $name }.
page-runs-changed = El programa ha cambiado desde entonces: las respuestas nombran líneas del programa anterior.
page-runs-other-program = Es una ejecución de otro programa: las respuestas nombran sus líneas.
page-runs-newest = Ejecución más reciente
page-runs-back = Volver a la ejecución más reciente
page-runs-console = La salida de la ejecución { $name }

# Dos ejecuciones comparadas.
page-runs-choose = Comparar { $name }
page-runs-compare = Comparar
page-runs-compare-help = Marca dos ejecuciones para compararlas.
page-runs-compare-end = Terminar la comparación
page-runs-compared = Comparación
page-runs-legend = Recorridos de las ejecuciones comparadas
page-runs-same = Las dos ejecuciones tomaron las mismas decisiones.
page-runs-together = Las dos ejecuciones hicieron lo mismo hasta { $seconds } s.
page-runs-moment-first = Ese momento en la primera ejecución
page-runs-moment-second = y en la segunda
