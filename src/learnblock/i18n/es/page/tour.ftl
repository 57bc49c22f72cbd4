# La visita guiada.

page-tour-title = Visita guiada
page-tour-offer = ¿Es tu primera vez? Haz una visita guiada de un minuto.
page-tour-begin = Empezar
page-tour-decline = No, gracias
page-tour-step = Paso { $number } de { $all }
page-tour-skip = Terminar la visita
page-tour-back = Atrás
page-tour-next = Siguiente
page-tour-done = Hecho
page-tour-blocks-title = Construye con bloques
page-tour-blocks = Arrastra bloques desde la lista y encájalos. Cada bloque le dice al robot que haga algo.
page-tour-texts-title = El mismo programa como texto
page-tour-texts = Block-Text y Python muestran el mismo programa como texto. Cambia una vista y las otras la siguen mientras escribes.
page-tour-run-title = Ejecútalo
page-tour-run = El botón verde ejecuta tu programa y el rojo lo para. También puedes pausarlo, ir paso a paso o reiniciarlo.
page-tour-world-title = Mira el robot
page-tour-world = Este es el robot en su mundo. Cuando no se ejecuta ningún programa, puedes arrastrarlo a otro sitio. La cámara y el mando están arriba; la salida, abajo.
page-tour-robot-title = Prueba otro robot
page-tour-robot = El mismo programa funciona en otros robots y en otros mundos. Elígelos aquí y ejecútalo otra vez.
