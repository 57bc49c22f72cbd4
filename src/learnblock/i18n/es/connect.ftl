# Conectar un robot real desde la página, sin programa.

connect-not-connected = No hay ningún robot conectado. Elige uno y conéctalo.
connect-given-up = El controlador del robot no responde y se ha abandonado la conexión. Puede que los motores sigan en marcha: apaga el robot.
connect-used-by-page = Este robot está conectado a otra página. Desconéctalo allí primero.
connect-used-by-run = Un programa está usando este robot. Detén el programa primero.
connect-wheels-stuck = El robot no ha llegado adonde debía. ¿Hay algo en su camino? ¿Tocan el suelo sus ruedas?
connect-needs-no-correction = Este robot mide sus ruedas él mismo, así que no hay nada que corregir.
