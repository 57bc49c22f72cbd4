# Jugar con otra persona de la clase en un mismo mundo.

page-pair-menu = Jugar en pareja…
page-pair-title = Jugar en pareja
page-pair-how = El programa de la otra persona mueve el segundo robot en tu mundo. La ejecución la empiezas tú.
page-pair-none-here = En este momento no puedes invitar a nadie de tu clase.
page-pair-inviting = Has invitado a { $name }. Espera su respuesta.
page-pair-take-back = Retirar la invitación
page-pair-invited = { $name } te invita a mover el robot { $robot } con tu programa, en su mundo.
page-pair-accept = Jugar
page-pair-decline = Ahora no
page-pair-host = El programa de { $name } mueve el robot { $robot } en tu mundo. Pulsa Ejecutar para empezar los dos.
page-pair-host-away = { $name } no ve tu mundo en este momento.
page-pair-guest = Tu programa mueve el robot { $robot } en el mundo de { $name }, que empieza la ejecución.
page-pair-world = El mundo de { $name }
page-pair-own-world = Mostrar mi mundo
page-pair-their-world = Mostrar el mundo de { $name }
page-pair-leave = Dejar de jugar en pareja
