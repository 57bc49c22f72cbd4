# Ejecutar un programa desde la página y mover su robot a mano.

play-robot-moves = El robot se está moviendo. Pausa o para el programa antes de colocarlo.
play-program-running = Hay un programa en marcha. Páralo primero.
play-no-question = El programa no espera ninguna respuesta.
play-no-robot = No hay ningún robot listo. Elige uno en la barra.
play-nothing-to-look-back-at = No hay nada que recordar. Ejecuta primero el programa.
play-not-started = No se ha podido ejecutar el programa: { $reason }
play-given-up = El programa no se detenía y se ha terminado a la fuerza. Puedes ejecutarlo otra vez.
play-given-up-real = El programa se ha terminado a la fuerza, pero su robot no responde. Puede que sus motores sigan en marcha: apágalo.
play-lost = La ejecución ha terminado de forma inesperada. Puede que no haya suficiente memoria: cierra otros programas o páginas y ejecuta el programa otra vez.

play-no-function = Este bloque no tiene ninguna función que reciba el robot. Escribe una primero.
play-wrong-count =
    { $most ->
        [0] La función «{ $function }» no recibe ningún valor, pero se le han dado { $count }.
       *[other]
            { $least ->
                [one] La función «{ $function }» recibe al menos 1 valor y como mucho { $most }, pero se le han dado { $count }.
               *[other] La función «{ $function }» recibe de { $least } a { $most } valores, pero se le han dado { $count }.
            }
    }
play-bad-number = { $value } no es un número que un bloque pueda usar.
play-bad-value = Un bloque solo puede usar números, textos, listas, verdadero y falso.
