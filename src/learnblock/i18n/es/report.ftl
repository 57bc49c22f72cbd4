# El informe al final de una ejecución en la línea de órdenes y la línea con su estado.

report-label-ended = fin
report-label-time = tiempo
report-label-driven = recorrido
report-label-goal = objetivo
report-label-shown = mostrado
report-label-no-effect = sin efecto
report-label-trace = traza
report-label-picture = dibujo

report-ended = { $how ->
    [finished] terminado
    [stopped] detenido
   *[other] acabado
}
report-ended-time-limit = en el límite de { $seconds } s (cámbialo con --for SEGUNDOS)

report-goal = { $name }: { $state ->
    [reached] logrado
    [failed] fallado
   *[other] no logrado
}
report-goal-at = { report-goal } a los { NUMBER($time, minimumFractionDigits: 1) } s

report-no-device = { $robot } no tiene { $device }
report-emotions-off = La cámara de { $robot } no reconoce emociones. Mira: learnblock perception

report-picture-format = { $file } tiene que ser un archivo .png o .svg.
report-no-picture = No hay nada que dibujar: el programa no ha usado ningún robot.

report-demo = Un EBO simulado busca etiquetas, se acerca a cada una y muestra un sentimiento.
report-connecting = conectando
report-speed = { NUMBER($factor, minimumFractionDigits: 1) } x tiempo real
