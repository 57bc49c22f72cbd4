# La página de inicio.

page-start-home = Inicio
page-start-places = Partes de la página
page-start-lessons = Lecciones
page-start-examples = Ejemplos
page-start-projects = Mis proyectos
page-start-teachers = Para docentes

## Lo primero

# $day es hoy, ayer o una fecha.
page-start-last = Último proyecto · { $day }
page-start-continue-text = Sigue donde lo dejaste.
page-start-continue = Continuar
page-start-first = Tu primer programa
page-start-first-text = Míralo y después cámbialo.
page-start-try = Pruébalo

## En una clase

page-start-handed-out = De tu profe
page-start-begin = Empezar
page-start-hand-ins = Entregas
page-start-no-hand-ins = Cuando entregues un paso de una lección aparecerá aquí, y también lo que diga tu profe.
page-start-improving = Lo estás mejorando
page-start-step = { $lesson } · paso { $step }

## Robots

page-start-robots = ¿Qué robot tienes?
page-start-no-robot = ¿No tienes robot? Aquí conduce uno simulado.
page-start-robot-ready = { $robot } está listo
page-start-robot-charge = { $robot } está listo · { $percent } %
page-start-connect = Conectar

## Lecciones y ejemplos

page-start-stage = Etapa
page-start-stage-starter = Principiante · 8–10
page-start-stage-explorer = Explorador · 10–13
page-start-stage-coder = Programador · 13–16
page-start-examples-title = Ejemplos
page-start-examples-help = Abre uno, pulsa Ejecutar, cámbialo
# $count es el número de tarjetas o de proyectos.
page-start-all = Todos: { $count }
page-start-all-examples = Todos los ejemplos

## Proyectos

page-start-new = Nuevo
page-start-import = Importar…
page-start-no-projects = Tus proyectos aparecen aquí. Empieza con un ejemplo o un programa nuevo, o suelta aquí un archivo.
page-start-open = Abrir
page-start-copy = Copiar…
page-start-more = Más sobre { $name }

## Para docentes

page-start-teachers-blocks-title = Elige los bloques
page-start-teachers-blocks = En el menú del proyecto, «Elegir bloques» limita la paleta a lo que necesita la lección. La elección se guarda en el proyecto.
page-start-teachers-notes-title = Notas y soluciones de cada lección
page-start-teachers-notes = El menú de una lección tiene notas, la solución de cada paso y programas incorrectos típicos con sus pistas. «Copiar y cambiar» hace de ella una lección tuya.
page-start-teachers-lesson-title = Crea tus lecciones
page-start-teachers-lesson = En el menú del proyecto, Crear una lección con este proyecto escribe una lección con pasos y comprobaciones. Aparece entre las lecciones y puedes descargarla para el alumnado, sin las soluciones.
page-start-teachers-share-title = Comparte un ejercicio como archivo
page-start-teachers-share = Descarga un proyecto y da el archivo a la clase. El alumnado lo suelta en esta página. Contiene el programa, su mundo, los nombres de etiquetas y los bloques propios.
page-start-teachers-robots-title = Varios robots en un mundo
page-start-teachers-robots = El + junto a la pestaña del robot añade otro robot con su propio programa, para jugar al fútbol o enviar mensajes.
page-start-teachers-grade-title = Evalúa a toda la clase
page-start-teachers-grade = La orden «learnblock grade» prueba todos los programas que ha entregado una clase, con las comprobaciones de una lección, y escribe una tabla y una página. Ninguna nota es definitiva.
page-start-teachers-grade-more = Qué hace learnblock grade
page-start-teachers-batch-title = Comprueba todos los programas a la vez
page-start-teachers-batch = La orden «learnblock run --variants» ejecuta un programa en cada variante de un mundo. Desde Python, learnblock.running.batch ejecuta los programas de toda la clase y enumera las metas alcanzadas.

page-start-grade-title = Evaluar a una clase con learnblock grade
page-start-grade-begin = Pon lo que ha entregado el alumnado (.learnblock, .bt o .py) en una carpeta: un archivo o una carpeta por persona. Después abre un terminal y escribe:
page-start-grade-runs = Cada programa se ejecuta en cada variante del mundo de la lección y en cada robot del paso. No puede llegar a tus archivos, a la red ni a los demás programas.
page-start-grade-results = La carpeta «results» tiene entonces una tabla, results.csv, y una página, results.html: las comprobaciones que cumple cada programa y por qué no las demás, los recorridos de los robots, las pistas adecuadas, grupos de programas con el mismo error y programas que se parecen.
page-start-grade-again = Una evaluación interrumpida continúa donde estaba. Los mismos programas obtienen siempre los mismos resultados.
page-start-grade-final = Ninguna nota es definitiva. Los resultados salen de reglas fijas, sin inteligencia artificial: tú decides lo que valen.
page-start-grade-more = «learnblock grade --help» y docs/grading.md (en inglés) tienen todas las opciones, como usar varios ordenadores a la vez.
page-start-grade-back = Volver
