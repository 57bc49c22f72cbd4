# Problemas y resultados.

page-problems-none = Sin problemas. El programa está listo para ejecutarse.
page-problems-runs-on = Este programa funciona en
page-problems-some = { $count ->
    [one] 1 error en el programa
   *[other] { $count } errores en el programa
    }
page-problems-errors = Errores
page-problems-warnings = Avisos
page-problems-last-run = En la última ejecución
page-problems-place = { $view }, línea { $line }
# $step is a block in its own words.
page-problems-block = Bloque «{ $step }»
page-problems-go-to = Ir al error
page-problems-add-robot = Añadir un robot
page-problems-stale = { $view } tiene un error en la línea { $line }. Las otras vistas muestran el último programa correcto.
page-problems-stale-somewhere = { $view } tiene un error. Las otras vistas muestran el último programa correcto.
page-problems-no-result = Ejecuta el programa para ver los resultados.
page-problems-ended-finished = Terminado
page-problems-ended-error = Detenido por un error
page-problems-ended-time-limit = Se acabó el tiempo
page-problems-ended-stopped = Parado
page-problems-ended-no-call = Detenido: demasiado tiempo sin usar el robot
page-problems-ended-output-limit = Detenido: escribió demasiado
page-problems-ended-killed = Terminado por el sistema
page-problems-goals-reached = { $all ->
    [one] { $reached } de 1 objetivo alcanzado
   *[other] { $reached } de { $all } objetivos alcanzados
    }
page-problems-time = Tiempo
page-problems-distance = Distancia recorrida
page-problems-goals = Objetivos
page-problems-goal-open = no alcanzado
page-problems-goal-reached = alcanzado
page-problems-goal-failed = fallido
page-problems-emotions = Emociones mostradas
page-problems-emotion-joy = alegría
page-problems-emotion-sadness = tristeza
page-problems-emotion-anger = enfado
page-problems-emotion-fear = miedo
page-problems-emotion-disgust = asco
page-problems-emotion-surprise = sorpresa
page-problems-emotion-neutral = neutra
page-problems-no-effect = Sin efecto
page-problems-missing = { $skill }: este robot no tiene { $device }
page-problems-emotions-off = { $skill }: en esta cámara no se reconocen emociones. En la etapa Programador, «Reconocimiento con la cámara» en el menú dice por qué.
page-problems-trace = Traza
page-problems-hash = Hash de la ejecución
page-problems-not-repeatable = Participó un robot real: esta ejecución no se puede repetir exactamente.
page-problems-hash-text = Dos ejecuciones con el mismo hash hicieron exactamente lo mismo.
page-problems-run-zero-division-error = No se puede dividir entre cero. Revisa el número que hay detrás del signo de división ({ $message }).
page-problems-run-name-error = Un nombre no tiene valor. Dale uno antes o revisa cómo está escrito ({ $message }).
page-problems-run-unbound-local-error = Se usa una variable antes de que tenga valor. Dale uno antes ({ $message }).
page-problems-run-type-error = Estos valores no se pueden combinar. Revisa si cada uno es un número, un texto o una lista ({ $message }).
page-problems-run-value-error = Un valor no sirve aquí. Revisa los valores ({ $message }).
page-problems-run-index-error = No hay ningún elemento en esa posición. La primera es la 0 ({ $message }).
page-problems-run-key-error = No hay ninguna entrada con ese nombre ({ $message }).
page-problems-run-attribute-error = Este valor no tiene nada con ese nombre. Revisa el nombre detrás del punto ({ $message }).
page-problems-run-recursion-error = Una función se llama a sí misma sin parar. Añade una condición que la termine ({ $message }).
page-problems-open-own-at = Abrir el bloque { $name } en la línea { $line }
page-problems-open-own = Abrir el bloque { $name }
