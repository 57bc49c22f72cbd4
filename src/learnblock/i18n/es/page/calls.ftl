# Qué llamó a qué en una ejecución.

page-calls-title = Qué llamó a qué en { $robot }
page-calls-none = Ejecuta el programa para ver a qué llama.
page-calls-count = { $count }× · { NUMBER($seconds, maximumFractionDigits: 1) } s
page-calls-function = { $name }, { $layer }: { $callers } lo llamó { $count ->
    [one] una vez
   *[other] { $count } veces
}, { NUMBER($seconds, maximumFractionDigits: 2) } s
page-calls-share = { $percent } %
page-calls-span = Intervalo de tiempo
page-calls-from = Desde (s)
page-calls-to = Hasta (s)
page-calls-from-here = Desde este momento
page-calls-to-here = Hasta este momento
page-calls-whole = Toda la ejecución
page-calls-beside = Llamadas una al lado de la otra
