# Lo que la página no puede hacer con el robot que observa.

monitor-program-running = Hay un programa en marcha. Páralo primero.
monitor-drive-real = Solo se puede conducir a mano un robot simulado. Elige uno en la lista de robots.
monitor-place-real = Solo se puede colocar a mano un robot simulado. Coge el de verdad y ponlo donde quieras.
monitor-handle-real = Aquí solo se puede sacudir e inclinar un robot simulado. Coge el de verdad con la mano.
