# La vista del programa en bloques.

page-blocks-label = Programa en bloques
page-blocks-search = Buscar
page-blocks-search-blocks = Buscar bloques
page-blocks-search-program = Buscar en el programa
page-blocks-previous = Anterior
page-blocks-next = Siguiente
page-blocks-close = Cerrar
page-blocks-loading = Cargando los bloques… Mientras tanto puedes editar el texto.
page-blocks-failed = No se han podido cargar los bloques. Comprueba que LearnBlock está en marcha y recarga la página.
page-blocks-new-when = Nuevo evento…
page-blocks-when-name = evento
page-blocks-when-prompt = Nombre del nuevo evento:
page-blocks-breakpoint = Punto de interrupción: el programa se pausa antes de este bloque
page-blocks-add-breakpoint = Añadir un punto de interrupción
page-blocks-remove-breakpoint = Quitar el punto de interrupción
page-blocks-show-in-texts = Mostrar en el código
page-blocks-search-hint = Escribe para buscar bloques
page-blocks-search-nothing = No hay bloques que coincidan
page-blocks-search-found = { $count ->
    [one] 1 bloque encontrado
   *[other] { $count } bloques encontrados
    }
page-blocks-slider = deslizador
page-blocks-angle = ángulo en grados, en el sentido de las agujas del reloj
page-blocks-colour = color
page-blocks-other-colour = otro color
page-blocks-tag = número o nombre de una etiqueta
page-blocks-colour-red = rojo
page-blocks-colour-orange = naranja
page-blocks-colour-yellow = amarillo
page-blocks-colour-green = verde
page-blocks-colour-cyan = cian
page-blocks-colour-blue = azul
page-blocks-colour-purple = morado
page-blocks-colour-pink = rosa
page-blocks-colour-white = blanco
page-blocks-colour-black = negro
page-blocks-own = Mis bloques
page-blocks-new-own = Bloque nuevo…
page-blocks-all-own = Gestionar mis bloques…
page-blocks-edit-own = Editar el código de este bloque…
page-blocks-call = llamada a una función
page-blocks-call-value = resultado de una función
