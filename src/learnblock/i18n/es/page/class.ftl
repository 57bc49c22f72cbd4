# Una clase: entrar, el panel de quien enseña, el proyector y lo que muestran las páginas del alumnado.

page-class-title = Clase { $title }

## Entrar

page-class-join = Entrar en la clase { $title }
page-class-join-text = Sin cuenta ni correo. Tu trabajo se queda en esta sala.
page-class-join-step = Paso { $step } de 3
page-class-word = 1 · Palabra de la pizarra
page-class-next = Siguiente
page-class-name = 2 · Tu nombre, sin apellidos
page-class-is-first-name = { $name } es mi nombre
page-class-whether = ¿Has estado aquí antes?
page-class-known = Ya he estado aquí
page-class-new = Vengo por primera vez
page-class-back = Atrás
page-class-given = Recibirás cuatro dibujos secretos: con ellos encuentras tu trabajo en cualquier dispositivo.
page-class-pictures = 3 · Toca tus cuatro dibujos secretos
page-class-take-back = Quitar el último dibujo
page-class-forgotten = ¿No los recuerdas? Tu profe puede darte otros.
page-class-join-do = Entrar
page-class-join-more = { $count ->
        [one] Entrar · falta 1
       *[other] Entrar · faltan { $count }
    }
page-class-chosen = { $count } de 4 dibujos
page-class-hello = ¡Hola, { $name }!
page-class-go-on = Continuar
page-class-not-me = No soy { $name }
page-class-remember = ¡Te damos la bienvenida, { $name }!
page-class-remember-text = Estos son tus dibujos secretos. Recuérdalos en este orden o apúntalos: los necesitarás la próxima vez.
page-class-remembered = Los recordaré
page-class-picture-apple = Manzana
page-class-picture-ball = Pelota
page-class-picture-bell = Campana
page-class-picture-boat = Barco
page-class-picture-car = Coche
page-class-picture-cloud = Nube
page-class-picture-fish = Pez
page-class-picture-flower = Flor
page-class-picture-heart = Corazón
page-class-picture-house = Casa
page-class-picture-key = Llave
page-class-picture-moon = Luna
page-class-picture-star = Estrella
page-class-picture-sun = Sol
page-class-picture-tree = Árbol
page-class-picture-umbrella = Paraguas

## El panel

page-class-no-key = Esta página es de quien enseña. Abre la dirección del panel que LearnBlock mostró al arrancar.
page-class-pupils = Alumnado
page-class-here = { $count ->
        [0] Aún no ha entrado nadie
        [one] Hay 1 persona
       *[other] Hay { $count } personas
    }
page-class-go-to = Abre
page-class-type-word = y escribe
page-class-open-or-scan = Abre en el navegador o escanea
page-class-name-and-pictures = Tu nombre y tus cuatro dibujos
page-class-join-address = Dirección
page-class-log-in = Inicia sesión como en el centro
page-class-open-door = Puede entrar gente nueva
page-class-renew-word = Otra palabra para entrar
page-class-sharing = Dejar jugar en pareja
page-class-showing = Dejar que se enseñen programas
page-class-eyes-up-button = Atención
page-class-stop-all = Parar todos los robots
page-class-hand-out = Repartir una lección
page-class-hint-all = Pista para todos
page-class-projector = Proyector
page-class-export-all = Descargar todo el trabajo
page-class-print-all = Imprimir todos los programas
page-class-print-none = Todavía no hay nada que imprimir, o la clase no responde.
page-class-hint = Pista
page-class-more = Más para { $name }
page-class-project = Mostrar en el proyector, sin el nombre
page-class-unproject = Mostrar la palabra para entrar en el proyector
page-class-renew-pin = Dibujos nuevos
page-class-export = Descargar el trabajo
page-class-remove = Eliminar
page-class-knocking = Ya han entrado { $count }. Te esperan: { $names }
page-class-lacks-lesson = La lección no llegó a { $names }. Repártesela otra vez; si no funciona, detén antes su servidor en el hub.
page-class-let-in = Dejar entrar hasta { $count } más
page-class-let-in-not = No dejar entrar
page-class-remove-several = Eliminar varias personas…
page-class-remove-which = Elige a quién quieres eliminar, con todo lo que ha hecho. Primero aparece quien entró más tarde.
page-class-remove-title = ¿Eliminar a { $name }?
page-class-remove-text = Se elimina todo lo que { $name } ha hecho en esta clase. No se puede deshacer. Descarga antes el trabajo si quieres conservarlo.
page-class-remove-not = Cancelar
page-class-pin-of = Dibujos nuevos de { $name }
page-class-pin-text = Díselos. Los anteriores ya no sirven.
page-class-hint-to = Pista para { $name }
page-class-hint-text = ¿En qué debería fijarse?
page-class-hint-send = Enviar
page-class-world-of = El mundo de { $name }
page-class-world-shown = El mundo de alguien de la clase
page-class-state-help = Pide ayuda
page-class-state-stuck = Atascado { $minutes } min
page-class-state-running = En marcha
page-class-state-editing = Editando
page-class-state-handed-in = Entregado
page-class-state-not-begun = Sin empezar
page-class-state-away = Ausente
page-class-filters = A quién se muestra
page-class-all = Todos
page-class-filter-help = Pide ayuda
page-class-filter-stuck = Atascado
page-class-filter-running = En marcha
page-class-filter-editing = Editando
page-class-filter-handed-in = Entregado
page-class-filter-not-begun = Sin empezar
page-class-filter-away = Ausente
page-class-order = Orden
page-class-order-need = Por ayuda
page-class-order-name = Por nombre
page-class-order-step = Por avance
page-class-changes = { $count ->
        [one] 1 cambio · Ordenar
       *[other] { $count } cambios · Ordenar
    }
page-class-lost = La clase no responde: está cerrada o su ordenador está en reposo. Lo que las páginas mostraban como guardado está guardado; los cambios posteriores se conservan en los dispositivos.
page-class-keys = Con las flechas vas de una persona a otra, y con una letra al siguiente nombre que empieza por ella. Intro abre su página, H escribe una pista y Mayús+F10 abre el menú. F6 pasa a la parte siguiente del panel.
page-class-open = Abrir
page-class-look = Mirar
page-class-said = «{ $question }»
page-class-asks = { $name } pide ayuda.
page-class-join-word = Palabra
page-class-more-tools = Más
page-class-level = Nivel { $level }
page-class-every-robot = todos los robots
page-class-left = quedan { $minutes } min
page-class-minutes = { $minutes } min
page-class-side = La clase
page-class-waiting-for-you = Te esperan
page-class-none-waiting = Nadie está esperando.
page-class-more-wait = y { $count } más
page-class-shows = enseña «{ $project }»
page-class-shown = Programas enseñados
page-class-shown-to = «{ $project }»: de { $name } a { $classmate }
page-class-tried = paso { $step } · { $tries } { $tries ->
        [one] intento
       *[other] intentos
    }
page-class-where = Por dónde va la clase
page-class-no-lesson = No has repartido ninguna lección.
page-class-mistake = Paso { $step }: a { $count } de { $tried } les falta esto: { $what }
# $count is the number of pupils who have finished the lesson that is on, $title that of the next one.
page-class-next-lesson = { $title }, para { $count ->
        [one] 1 que ha acabado
       *[other] { $count } que han acabado
    }
page-class-next-given = La lección «{ $title }» está abierta en las páginas de { $count ->
        [one] 1 persona
       *[other] { $count } personas
    }.
page-class-hand-ins = Entregas
page-class-some-of = { $count } de { $all }
page-class-no-hand-ins = Aún no ha terminado nadie.
# Of a hand-in, if the pupil has another step open, or another lesson with $title.
page-class-of-step = paso { $step }
page-class-of-lesson = { $title }, paso { $step }
page-class-pupil = Nombre
page-class-stars = Estrellas
page-class-tries = Intentos
page-class-mark = Nota
page-class-to-mark = por calificar
page-class-done = terminado
page-class-hint-kept = No hay conexión. La pista se conserva: envíala otra vez cuando vuelva la conexión.
page-class-hint-text-all = ¿En qué debería fijarse todo el mundo?
page-class-lessons = Lecciones
page-class-find-lesson = Buscar una lección
page-class-add-lesson = Añadir mi lección…
page-class-delete-lesson-text = El archivo de la lección se elimina de este ordenador. Quien haya empezado la lección la conserva.
page-class-no-such-lesson = Ninguna lección tiene esas palabras.
page-class-own-lessons = Mis lecciones { $count }
page-class-lesson-on = En curso
page-class-lesson-next = Siguiente
page-class-lesson-own = Mía
page-class-to-everyone = Se abre en la página de cada persona, también de quien llegue más tarde.
page-class-hand-out-do = Repartir
page-class-hand-out-one = Repartir una lección…
page-class-receiving = Quién recibe la lección
page-class-to-all = A toda la clase
# $count is a number of pupils.
page-class-to-some = { $count ->
        [0] A algunas personas…
        [one] A 1 persona
       *[other] A { $count } personas
    }
page-class-to-these = Se abre en las páginas de estas personas. Quien no esté la recibe al volver.
page-class-from = El paso por el que se empieza
page-class-from-own = Donde lo dejó cada cual
# $title is that of a step.
page-class-from-step = Desde el paso { $step }: { $title }
page-class-step = { $title } · paso { $step } de { $steps } · { $stars } ★

## En una página que muestra el programa de alguien

page-class-hand = Necesito ayuda
page-class-question = ¿Con qué necesitas ayuda?
page-class-told = Tu profe ya puede verlo
page-class-tell = Decírselo
page-class-no-help = Ya no necesito ayuda
page-class-notes = De tu clase
page-class-hint-from = Tu profe:
page-class-asked = Tu profe quiere escribir en tu programa.
page-class-let = Dejar que escriba
page-class-let-not = Ahora no
page-class-writes = Tu profe puede escribir en tu programa.
page-class-enough = Ya basta
page-class-looking = Estás mirando el programa de { $name }.
page-class-ask = Pedir permiso para escribir
page-class-waiting = Has pedido a { $name } permiso para escribir.
page-class-ask-not = Déjalo
page-class-may = Puedes escribir en el programa de { $name }.
page-class-stop-writing = Volver a solo mirar
page-class-lost-saved = Tu clase no responde. Todo lo que has hecho está guardado. Sigue trabajando: continuará cuando vuelva el ordenador de tu profe.
page-class-lost-unsaved = Tu clase no responde. Sigue trabajando: tus cambios se conservan en este dispositivo y se guardarán cuando vuelva el ordenador de tu profe.
page-class-eyes-up = ¡Atención!
page-class-eyes-up-text = Mira a tu profe un momento.
page-class-eyes-up-safe = Tu programa está a salvo. Tu robot espera.
