# Ejecuciones guardadas de un proyecto.

kept-no-such = Esta ejecución ya no está guardada.
kept-no-room = Un proyecto guarda como máximo { $most } ejecuciones con nombre, y { $size } MB de ellas. Borra una antes.
kept-no-project = No hay ningún proyecto { $name }. Vuelve a abrirlo.
kept-upload-busy = Todavía se están abriendo otros archivos. Espera a que terminen y prueba otra vez.
kept-upload-slow = El archivo no llegó a tiempo. Inténtalo otra vez.
# Lo que no se puede mostrar de una ejecución abierta; $robot es el identificador de un robot.
kept-world-missing = El mundo "{ $world }" de esta ejecución, o su robot { $robot }, no está en este ordenador: solo se muestra lo que se registró.
kept-real-robot = Esta ejecución fue en un robot real ({ $robot }): solo se muestra lo que se registró.
