# Evaluación: learnblock grade y su página.

grade-running = Evaluando
grade-stopped = Detenido. Los resultados hasta ahora están escritos; la misma orden hace después lo que falta.
grade-written = Resultados: { $file }
grade-not-made = No se { $count ->
        [one] ha podido hacer { $count } ejecución
       *[other] han podido hacer { $count } ejecuciones
    }: { $reason } La misma orden hace lo que falta.
grade-files-or-class = Indica los archivos o carpetas que hay que evaluar, o una clase con --class NOMBRE.
grade-jobs-or-scheduler = Usa --jobs o --scheduler, pero no los dos.
grade-nothing-handed-in = No hay ningún programa (.bt, .py o .learnblock) en lo entregado.
grade-no-checks = Ningún paso de { $lesson } tiene comprobaciones.
grade-real-robot = { $robot } es un robot real. Para evaluar hacen falta robots simulados, como sim-ebo.
grade-many-programs = Hay más de { $most } programas en la carpeta: { $files } ... Deja solo los que haya que evaluar.
grade-no-program = No hay ningún programa (.bt, .py o .learnblock) en la carpeta.
grade-not-begun = No ha empezado este paso.
grade-not-handed-in = Todavía no ha entregado este paso.
grade-left-out = { $file } tiene archivos que no se pueden descomprimir: { $names }{ $more ->
    [0] .
   *[other] { " " }y { $more } más.
} Quedan fuera; los demás se evalúan.
grade-zip-damaged = { $file } está dañado o cifrado, o no es un zip. Descárgalo de nuevo, o descomprímelo y evalúa la carpeta.
grade-zip-too-large = { $file } tiene demasiado para una sola clase. Descomprímelo y evalúa una parte cada vez.
grade-folder-in-use = Otra evaluación está usando { $folder }. Espera a que termine o elige otra carpeta.
grade-other-version = Este ordenador tiene LearnBlock { $here }, pero la evaluación empezó con { $there }. Instala la misma versión en todos.
grade-no-dask = Los clústeres necesitan un complemento que no está instalado. Instálalo con: { $command }
grade-no-scheduler = Ningún planificador de Dask responde en { $address }. ¿Está en marcha? ¿Es correcta la dirección?
grade-no-workers = El planificador de Dask en { $address } no tiene trabajadores. Inicia al menos uno: dask worker { $address }
grade-workers-lost = Los trabajadores se perdieron una y otra vez. Lo terminado se conserva; la misma orden hace después lo que falta.
grade-trace-too-long = El programa hizo tanto que su registro ocupa más de { $limit } MB. No se evalúa.

grade-page-title = { $lesson }, paso { $step }
grade-page-programs = Programas
grade-page-tried = { $tries ->
    [one] probados una vez
   *[other] cada uno probado { $tries } veces
}
grade-page-of = de { $count }
grade-page-without = Sin programa
grade-page-most-missed = Lo que más falla
grade-page-to-look-at = Por revisar
grade-page-no-mark = Ninguna nota es definitiva: decides tú. Estos resultados salen de reglas fijas que solo cuentan lo que hizo un robot en un simulador y cómo está construido un programa. No saben qué ha entendido, probado u oído un alumno. No interviene ninguna inteligencia artificial.
grade-page-overview = Resumen
grade-page-pupil = Alumno
grade-page-pupils = Todos los programas
grade-page-done = Paso conseguido
grade-page-done-in = paso conseguido en { $done } de { $tries }
grade-page-first-hint = Primera pista
grade-page-clusters = Errores parecidos
grade-page-no-clusters = No hay dos programas que fallen en las mismas comprobaciones con la misma pista.
grade-page-cluster = { $count } programas fallan en:
grade-page-alike = Programas parecidos
grade-page-alike-note = Los programas se comparan sin comentarios ni formato. «Igual» es el mismo programa; «igual salvo los nombres» tiene otros nombres de variables y funciones; «parecido» comparte al menos el 80 % de sus partes de seis palabras, sin las del programa con el que empezaron todos. Los programas cortos para una misma tarea se parecen de por sí, y puede que los alumnos hayan trabajado juntos: esto no dice quién escribió qué.
grade-page-none-alike = No hay dos programas parecidos.
grade-page-more-alike = Hay { $count } pares más que se parecen.
grade-page-kind-same = igual
grade-page-kind-renamed = igual salvo los nombres
grade-page-kind-alike = { $share } % parecido
grade-page-hints = Pistas que encajan
grade-page-differs = Una ejecución de este programa en un mismo proceso con su robot fue distinta de una aislada. Todas sus ejecuciones se repitieron aisladas, y esas son las que cuentan.
grade-page-not-made = No se pudo hacer una ejecución: { $error }
grade-page-again = Para repetirlo:
grade-page-program = Programa
grade-page-attempt = { $robot }, variante { $variant }, semilla { $seed }
grade-page-robot = Robot
grade-page-variant = Variante
grade-page-seed = Semilla
grade-page-ended = Final
grade-page-seconds = Segundos
grade-page-checked = Cómo se comprobó
grade-page-trace = Traza (SHA-256)
grade-page-not-finished = sin terminar
grade-page-not-run = no se ha podido ejecutar
