# El cuadro de diálogo en el que un docente crea o cambia una lección.

page-maker-menu = Crear una lección con este proyecto…
page-maker-make-title = Crear una lección
page-maker-change-title = Cambiar lección
page-maker-change = Cambiar…
page-maker-parts = Partes de la lección
page-maker-part-about = Sobre la lección
page-maker-part-teacher = Para el docente
# $title es el título del paso.
page-maker-step = { $number }. { $title }
page-maker-new-step = Paso nuevo
page-maker-add-step = Añadir un paso
page-maker-step-up = Subir este paso
page-maker-step-down = Bajar este paso
page-maker-step-delete = Eliminar este paso
page-maker-languages = Idioma en el que escribes
# $text es el texto en otro idioma.
page-maker-fallback = Se muestra hasta que lo escribas: { $text }
page-maker-save = Guardar lección
page-maker-saved = «{ $title }» está entre tus lecciones. La encuentras en la página de inicio.
page-maker-is-saved = Guardada
page-maker-not-saved = Sin guardar
page-maker-unsaved = «{ $title }» no está guardada.
page-maker-go-on = Seguir editando
page-maker-discard = Descartar los cambios
page-maker-problems = { $count ->
    [one] Falta algo o hay 1 error:
   *[other] Faltan cosas o hay errores ({ $count }):
}
page-maker-place-step = Paso { $number }
page-maker-place-title = Título
page-maker-place-level = Nivel
page-maker-place-minutes = Minutos
page-maker-place-aims = Objetivos
page-maker-place-robots = Robots de esta lección
page-maker-place-text = Instrucciones
page-maker-place-program = Programa inicial
page-maker-place-solution = Solución
page-maker-place-world = Mundo
page-maker-place-blocks = Bloques
page-maker-place-variants = Variantes
page-maker-place-seconds = Segundos
page-maker-place-check = Comprobaciones
page-maker-place-hint = Pistas
page-maker-place-quiz = Pregunta
page-maker-place-puzzle = Rompecabezas
page-maker-place-partners = Otros robots

## Sobre la lección

page-maker-title = Título
page-maker-level = Nivel
page-maker-minutes = Minutos
page-maker-aims = Objetivos
page-maker-aims-help = Lo que aprende el alumnado, en frases cortas.
page-maker-aim-number = Objetivo { $number }
page-maker-aim = Qué se aprende
page-maker-add-aim = Añadir un objetivo
page-maker-robots = Robots de esta lección
page-maker-robots-help = Los robots para los que es la lección.
page-maker-usual-robot = Robot habitual

## Un paso

page-maker-step-title = Título del paso
page-maker-phase = Tipo de paso
page-maker-text = Instrucciones (Markdown)
page-maker-text-help = Un bloque de código que empieza con ```blocks se dibuja con bloques.
page-maker-preview = Lo que ve el alumnado
page-maker-as-before = Como en el paso anterior
page-maker-program = Programa inicial
page-maker-program-text = Texto del programa inicial
page-maker-empty = Vacío
page-maker-in-blocktext = En Block-Text
page-maker-in-python = En Python
page-maker-take-program = Usar el programa abierto
page-maker-world = Mundo
page-maker-robots-world = El mundo habitual del robot
page-maker-blocks = Bloques visibles
page-maker-all-blocks = Todos los bloques
page-maker-some-blocks = { $count } bloques elegidos
page-maker-variants = Variantes del mundo
page-maker-seconds = Ejecución más larga (segundos)
page-maker-keys = Teclas que se pulsan
page-maker-keys-help = Cuando las comprobaciones se hacen sin jugador, se pulsan estas teclas. Los tiempos son los del robot, así que cada ejecución es igual.
page-maker-press = Pulsación { $number }
page-maker-add-press = Añadir una pulsación
page-maker-press-key = Tecla
page-maker-press-at = Primera vez (segundos)
page-maker-press-seconds = Se mantiene (segundos)
page-maker-press-times = Cuántas veces
page-maker-press-every = Segundos entre una y otra
page-maker-solution-title = Solo para el docente
page-maker-solution = Solución
page-maker-no-solution = Sin solución
page-maker-take-solution = Usar el programa abierto como solución
page-maker-solution-text = Programa de la solución

## Comprobaciones

page-maker-checks = Comprobaciones
page-maker-checks-help = Metas que LearnBlock busca en lo que hizo el robot y en el programa.
page-maker-check = Comprobación { $number }
page-maker-check-unfinished = Rellena los campos para ver esta comprobación en palabras.
page-maker-add-check = Añadir una comprobación
page-maker-kind = Qué se comprueba
page-maker-say = Otras palabras para el alumnado (opcional)
page-maker-optional = Extra: da una estrella propia
page-maker-none = (nada)
page-maker-lines-help = Uno en cada línea
page-maker-kind-goals = Se alcanzan metas del mundo
page-maker-kind-happens = Ocurre algo
page-maker-kind-never = Algo no ocurre nunca
page-maker-kind-in-order = Ocurren cosas en orden
page-maker-kind-on-line = El robot sigue una línea
page-maker-kind-drives = El robot recorre una distancia
page-maker-kind-ends-at = El robot acaba en un lugar
page-maker-kind-turns = El robot ha girado un ángulo
page-maker-kind-ends = El programa termina por sí solo
page-maker-kind-prints = El programa escribe líneas
page-maker-kind-python = Una función de checks.py
page-maker-kind-uses = El programa usa algo
page-maker-kind-size = El programa es corto
page-maker-event = Qué ocurre
page-maker-event-number = Suceso { $number }
page-maker-add-event = Añadir un suceso
page-maker-event-goal = Se alcanza una meta
page-maker-event-shows = El robot muestra algo
page-maker-event-says = El robot dice algo
page-maker-event-prints = El programa escribe una línea
page-maker-event-calls = El programa llama a una habilidad
page-maker-event-sends = El programa envía un mensaje
page-maker-event-collision = El robot choca con algo
page-maker-event-at = El robot llega a un lugar
page-maker-event-stands = El robot se queda quieto
page-maker-key-goals = Metas (ninguna: todas)
page-maker-key-within = En menos de (segundos, opcional)
page-maker-key-at-least = Como mínimo
page-maker-key-at-most = Como máximo (opcional)
page-maker-key-line = Línea
page-maker-key-share = Parte del tiempo (de 0 a 1)
page-maker-key-distance = Mayor distancia a la línea (mm)
page-maker-key-least = Recorrido mínimo (mm)
page-maker-key-x = X (mm)
page-maker-key-y = Y (mm)
page-maker-key-radius = Radio (mm)
page-maker-key-heading = Orientación (°, opcional)
page-maker-key-angle = Mayor error de orientación (°)
page-maker-key-by = Ángulo (°, en sentido horario)
page-maker-key-tolerance = Mayor error (°)
page-maker-key-lines = Líneas
page-maker-key-construct = Parte de un programa
page-maker-key-skill = Habilidad
page-maker-key-function = Función
page-maker-key-blocks = Bloques como máximo
page-maker-key-name = Meta
page-maker-key-what = Texto (* es cualquier cosa)
page-maker-key-message = Mensaje
page-maker-key-thing = Objeto (* es cualquiera)
page-maker-key-seconds = Segundos

## Pistas y preguntas

page-maker-hints = Tus pistas
page-maker-hints-help = LearnBlock ya tiene pistas. Las tuyas van antes.
page-maker-hint = Pista { $number }
page-maker-add-hint = Añadir una pista
page-maker-hint-check = Cuando falla esta comprobación
page-maker-any-check = Cualquier comprobación
page-maker-hint-level-1 = Primero: dónde mirar
page-maker-hint-level-2 = Después: qué parte (opcional)
page-maker-hint-level-3 = Por último: cómo, en general (opcional)
page-maker-quiz = Pregunta
page-maker-quiz-on = Hacer una pregunta en este paso
page-maker-question = Pregunta
page-maker-answer = Respuesta { $number }
page-maker-answer-text = Respuesta
page-maker-answer-right = Esta respuesta es correcta
page-maker-because = Por qué es correcta o no (opcional)
page-maker-add-answer = Añadir una respuesta
page-maker-puzzle = Rompecabezas
page-maker-puzzle-on = El alumnado ordena las líneas de un programa
page-maker-puzzle-program = Programa en el orden correcto (Block-Text)
page-maker-puzzle-also = Orden correcto { $number }
page-maker-puzzle-also-program = Las mismas líneas en otro orden que también es correcto (Block-Text)
page-maker-add-order = Añadir otro orden correcto
page-maker-distractors = Líneas que no son del programa

## Para el docente

page-maker-teacher-help = El alumnado nunca recibe estas notas ni las soluciones.
page-maker-notes = Notas para el docente
page-maker-trial = Probar las comprobaciones
page-maker-trial-help = Ejecuta cada solución en todos los robots y variantes y dice qué comprobaciones cumple.
page-maker-trial-start = Probar las comprobaciones con las soluciones
page-maker-trial-stop = Parar
page-maker-trial-done = { $done } de { $count } ejecuciones
page-maker-trial-none = Ningún paso tiene solución todavía.
page-maker-tried-solution = Paso { $step }: la solución pasa en { $right } de { $attempts } ejecuciones.
page-maker-tried-wrong = Paso { $step }: un programa erróneo falla en { $right } de { $attempts } ejecuciones, como debe.
page-maker-tried-none = El paso { $step } tiene comprobaciones, pero no solución.
page-maker-downloads = Compartir la lección
page-maker-downloads-help = Antes se guarda la lección. El alumnado abre el archivo en la página de inicio.
page-maker-download-pupils = Descargar para el alumnado
page-maker-download-teacher = Descargar con la parte del docente
