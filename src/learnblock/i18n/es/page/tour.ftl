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
page-tour-add-title = Añade un bloque
page-tour-add = Abre Mover y arrastra un bloque a tu programa, o pulsa Intro sobre él.
page-tour-change-title = Cambia un número
page-tour-change = Haz clic en un número de un bloque y escribe otro.
page-tour-run-title = Ejecútalo
page-tour-run = Pulsa el botón verde y mira el robot.
page-tour-texts-title = Míralo como texto
page-tour-texts = El mismo programa como texto: elige Block-Text o Python. Si cambias uno, los demás lo siguen.
page-tour-robot-title = Prueba otro robot
page-tour-robot = El mismo programa funciona en otros robots. Elige uno aquí y ejecútalo otra vez.
page-tour-well-done = ¡Hecho!
