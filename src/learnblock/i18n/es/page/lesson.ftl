# Lecciones: sus tarjetas en la página de inicio y el panel junto al programa.

## Las tarjetas

page-lesson-cards-title = Lecciones
page-lesson-cards-levels = Nivel
page-lesson-cards-level-1 = 1 · Primer viaje
page-lesson-cards-level-2 = 2 · Sentir y decidir
page-lesson-cards-level-3 = 3 · Funciones y estados
page-lesson-cards-level-4 = 4 · Ver y cooperar
page-lesson-minutes = { $minutes } min
page-lesson-stars-of = { $earned } de { $stars } estrellas
page-lesson-stars-short = { $earned }/{ $stars }
page-lesson-go-on = Paso { $step } de { $count }
page-lesson-add = Añadir una lección
page-lesson-add-file = De un archivo…
page-lesson-add-folder = De una carpeta…
page-lesson-no-folder = Esta carpeta no tiene lesson.toml, así que no es una lección. Elige la carpeta en la que está lesson.toml.
page-lesson-own = Mi lección
page-lesson-delete = Eliminar { $title }
page-lesson-more = Más de { $title }
page-lesson-delete-menu = Eliminar…
page-lesson-delete-help = Se elimina el archivo de la lección. Los proyectos empezados con ella se quedan, sin la lección.
page-lesson-delete-now = Eliminar lección
page-lesson-notes = Notas y soluciones
page-lesson-copy = Copiar y cambiar…
page-lesson-notes-title = { $title }: notas y soluciones
page-lesson-notes-none = Esta lección no tiene notas ni soluciones.
page-lesson-notes-solution = Solución
page-lesson-notes-no-solution = Este paso no tiene ningún programa que resolver.
page-lesson-notes-wrong = Programas incorrectos típicos
page-lesson-notes-fails = No cumple: { $check }
page-lesson-notes-hint = Su pista:
page-lesson-worksheet = Guardar ficha
page-lesson-worksheet-help = Una página para imprimir: tareas, bloques para recortar, líneas para escribir y las soluciones aparte
page-lesson-cards-next = Empieza aquí
page-lesson-cards-none = Aún no hay lecciones de este nivel.
page-lesson-again = Empezar { $title } otra vez
page-lesson-imported = «{ $title }» ya está entre tus lecciones.
page-lesson-too-large = { $name } es demasiado grande para una lección.

## El panel

page-lesson-text = Instrucciones y metas
page-lesson-level = Nivel { $level }
page-lesson-step-of = Paso { $step } de { $count }
page-lesson-phase-predict = Predice
page-lesson-phase-run = Ejecuta
page-lesson-phase-investigate = Investiga
page-lesson-phase-modify = Cambia
page-lesson-phase-make = Crea
page-lesson-stars = { $stars ->
    [one] { $earned } de 1 estrella en este paso
   *[other] { $earned } de { $stars } estrellas en este paso
}
page-lesson-fold = Mostrar u ocultar las instrucciones
# Instead of a drawing of the program, which is open anyway.
page-lesson-program-there = Es el programa que tienes en el editor.
page-lesson-previous = Paso anterior
page-lesson-next = Siguiente
page-lesson-finish = Terminar
page-lesson-restart = Empezar este paso otra vez
page-lesson-goals = Metas
# Looks at the place in the world where a goal was missed.
page-lesson-show = Mostrar
page-lesson-optional = (extra)
page-lesson-goal-open = sin alcanzar todavía
page-lesson-goal-met = alcanzada
page-lesson-goal-failed = no alcanzada
page-lesson-met-said = Alcanzado: { $goals }
page-lesson-star-said = ¡Has ganado una estrella!

## Pistas

page-lesson-hint = ¿Una pista?
page-lesson-hint-offer = ¡Todavía no! Mira las metas o pide una pista.
page-lesson-hints-taken = { $count ->
    [one] 1 pista en este paso.
   *[other] { $count } pistas en este paso.
}
page-lesson-hints-more = Pulsa el botón otra vez para leer más.
page-lesson-hints-all = Era la última pista. Cambia algo y ejecuta el programa otra vez.

## Preguntas y rompecabezas

page-lesson-answer = Comprobar
page-lesson-right = ¡Correcto!
page-lesson-wrong = Casi. Inténtalo otra vez.
page-lesson-puzzle = Ordena las piezas
page-lesson-puzzle-help = Elige una pieza para añadirla al programa. No todas las piezas son del programa.
page-lesson-pieces = Piezas
page-lesson-order = Tu programa
page-lesson-piece-else = si no
page-lesson-piece-add = Añadir
page-lesson-piece-up = Subir
page-lesson-piece-down = Bajar
page-lesson-piece-remove = Devolver
page-lesson-puzzle-good = { $count ->
    [0] La primera pieza es otra.
    [one] La primera pieza está bien.
   *[other] Las primeras { $count } piezas están bien.
}

## Todas las variantes y todos los robots

page-lesson-everywhere = Probar en todo
page-lesson-everywhere-help = Comprobar en todas las variantes del mundo y con todos los robots de este paso
page-lesson-everywhere-stop = Detener la comprobación
page-lesson-everywhere-title = Todas las variantes y robots
page-lesson-everywhere-progress = { $done } de { $count } comprobados
page-lesson-everywhere-passed = { $passed } de { $count } superados
page-lesson-everywhere-yes = ¡Tu programa funciona en todas partes!
page-lesson-everywhere-no = Tu programa todavía no funciona en todas partes.
page-lesson-attempt = { $variant ->
    [0] { $robot }, mundo original
   *[other] { $robot }, variante { $variant }
}
page-lesson-replay = Ver
page-lesson-replay-of = Ver { $where }
