# La consola.

page-console-empty = Aquí aparece lo que escribe el programa.
page-console-lines = Salida del programa
page-console-copy = Copiar
page-console-clear = Vaciar
page-console-open = Mostrar toda la salida
page-console-heard-here = { $robot } no tiene altavoz: lo oyes en este ordenador.
page-console-asks = El programa pregunta:
page-console-answer = Responder
# $number counts the runs since the program was opened; $time is the time of day.
page-console-run = Ejecución { $number } · { $time }
page-console-warning = Aviso: { $message }
page-console-more-warnings = { $count ->
    [one] Hay un aviso más entre los problemas.
   *[other] Hay { $count } avisos más entre los problemas.
}
page-console-bumped = El robot ha chocado con { $thing } a los { $time } s.
page-console-finished = Terminado a los { $seconds } s.
page-console-stopped = Parado a los { $seconds } s.
page-console-time-limit = Tiempo límite alcanzado a los { $seconds } s.
page-console-error = Detenido por un error a los { $seconds } s.
page-console-no-call = Detenido a los { $seconds } s: el programa llevaba demasiado tiempo sin usar el robot.
page-console-output-limit = Detenido a los { $seconds } s: el programa ha escrito demasiado.
page-console-killed = Terminado por el sistema a los { $seconds } s.
