# Lo que se entrega: la página con las entregas, y lo que ven los alumnos.

## Las entregas

page-handins-title = Entregas
page-handins-wall = Panel
page-handins-check = Comprobar { $count }
page-handins-check-again = Comprobar otra vez
page-handins-checking = Comprobando
page-handins-progress = { $done } de { $total } ejecuciones
page-handins-stop = Detener
page-handins-back-all = Devolver { $count }
page-handins-tables = Tablas
page-handins-csv = Notas (CSV)
page-handins-moodle = Notas para Moodle (CSV)
page-handins-results = Todas las ejecuciones (CSV)
page-handins-report = Informe de todos los programas
page-handins-lesson = Lección
page-handins-steps = Pasos
page-handins-starts = { $count ->
        [one] probado una vez
       *[other] cada uno, probado desde { $count } salidas
    }
page-handins-no-lesson = Aún nadie trabaja en una lección. Reparte una desde el panel.
page-handins-none = Nadie ha entregado todavía el paso { $step }.
page-handins-often = Lo más frecuente:
page-handins-pupils = ({ $count } personas)
page-handins-pupil = Nombre
page-handins-stars-head = Estrellas
page-handins-tries = Intentos
page-handins-missed = Qué ha faltado
page-handins-mark = Nota
page-handins-state-to-check = Por comprobar
page-handins-state-to-mark = Por calificar
page-handins-state-marked = Calificadas, sin devolver
page-handins-state-handed-back = Devueltas
page-handins-state-improving = Mejorando
page-handins-to-mark = por calificar
page-handins-unchecked = sin comprobar
page-handins-nothing = nada
page-handins-stars = { $stars } de 3 estrellas
page-handins-not-begun = sin empezar · sin nota, y no cuenta en ningún error
page-handins-not-handed-in = aún sin entregar
page-handins-collect = Recoger ahora
page-handins-at = { $tries ->
        [0] entregado el { $time }
        [one] 1 intento, entregado el { $time }
       *[other] { $tries } intentos, entregado el { $time }
    }
page-handins-collected-at = { $tries ->
        [0] recogido el { $time }
        [one] 1 intento, recogido el { $time }
       *[other] { $tries } intentos, recogido el { $time }
    }
page-handins-nameless = Mostrar sin nombre
page-handins-nameless-title = Un programa del paso { $step }
page-handins-previous = La anterior
page-handins-next = La siguiente
page-handins-program = Programa
page-handins-checks = Comprobaciones
page-handins-met = { $met } de { $runs }
page-handins-check-first = Sin comprobar: pulsa Comprobar para probarlo desde todas las salidas.
page-handins-why = ¿Por qué?
page-handins-way = Por dónde fue el robot de { $name }
page-handins-run-show = Ver la ejecución
page-handins-run-hide = Desde arriba
page-handins-run-of = La ejecución de { $name }
page-handins-seconds = { NUMBER($seconds, maximumFractionDigits: 1) } s
page-handins-note = Mensaje para
page-handins-about = Sobre
page-handins-about-all = todo el programa
page-handins-about-gone = { $line } (no está en este programa)
page-handins-your-mark = Tu nota
page-handins-back = Devolver
page-handins-back-again = Devolver otra vez
page-handins-earlier = Devuelto hasta ahora: { $marks }

## Entregar, en la página de quien aprende

page-handins-own = Entregar
page-handins-own-again = Entregar otra vez
page-handins-own-waits = Entregado. Tu profe lo va a mirar.
page-handins-own-back = Tu trabajo ha vuelto
page-handins-own-mark = Tu nota: { $mark }
page-handins-own-teacher = Tu profe:
page-handins-own-line = Mira: { $line }
page-handins-own-gone = (Era sobre { $line }, que ya no está en tu programa.)
page-handins-own-improve = Mejorar y entregar otra vez
page-handins-your-run = Tu ejecución
page-handins-own-run = El programa que entregaste, en marcha
page-handins-own-later = Más tarde
page-handins-own-improving = Lo estás mejorando. Entrégalo otra vez cuando esté listo.
