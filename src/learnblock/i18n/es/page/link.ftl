# La conexión con un robot de verdad, encima del mundo.

page-link-disconnected = Sin conexión
page-link-connected = Conectado
page-link-weak = Conexión débil
page-link-lost = Conexión perdida
page-link-battery = batería { $volts } V
page-link-quality = Llega el { $percent } % de los mensajes del robot.

page-link-weak-said = La conexión con el robot es débil.
page-link-lost-said = Se ha perdido la conexión con el robot. ¿Está encendido y cerca?

page-link-robot-unlocated = { $robot } sobre un suelo vacío. No se sabe dónde está
page-link-plain-floor = Un suelo vacío con el robot.
page-link-drive-simulated = Solo se puede conducir a mano un robot simulado.
page-link-place-simulated = Solo se puede colocar un robot simulado. Coge el de verdad y ponlo donde quieras.
