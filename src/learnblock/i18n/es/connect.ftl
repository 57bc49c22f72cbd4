# Conectar un robot real desde la página, sin programa.

connect-not-connected = No hay ningún robot conectado. Elige uno y conéctalo.
connect-given-up = El controlador del robot no responde y se ha abandonado la conexión. Puede que los motores sigan en marcha: apaga el robot.
connect-used-by-page = Este robot está conectado a otra página. Desconéctalo allí primero.
connect-used-by-run = Un programa está usando este robot. Detén el programa primero.
connect-wheels-stuck = El robot no ha llegado adonde debía. ¿Hay algo en su camino? ¿Tocan el suelo sus ruedas?
connect-needs-no-correction = Este robot mide sus ruedas él mismo, así que no hay nada que corregir.

# Instalar lo que un robot necesita además de LearnBlock.
connect-installs-another = Todavía se está instalando el complemento de '{ $robot }'. Espera a que termine o detenlo.
connect-not-ours-to-install = Otras personas usan también esta instalación de LearnBlock. Pide a quien se ocupa de ella que instale el complemento de '{ $robot }'.
connect-no-installer = No se ha encontrado el instalador '{ $name }' en este ordenador. Usa la orden de abajo en la terminal en la que instalaste LearnBlock.
connect-install-offline = Este ordenador no puede conectarse al índice de paquetes. Conéctalo a Internet y vuelve a intentarlo.
connect-install-failed = No se ha podido instalar el complemento. El instalador dice: { $reason }
connect-install-too-long = La instalación del complemento ha tardado más de { $minutes } minutos y se ha detenido. Vuelve a intentarlo con una red más rápida.
connect-installed-restart = El complemento está instalado. Reinicia LearnBlock para que lo encuentre.
