# The gallery of worlds.


page-gallery-open = Todos los mundos…
page-gallery-title = Elige un mundo
page-gallery-search = Buscar mundos
page-gallery-groups = Qué se hace allí
page-gallery-all = Todos
page-gallery-all-of = Los { $count }
page-gallery-all-worlds = Los { $count } mundos
page-gallery-count = { $count ->
    [one] Un mundo
   *[other] { $count } mundos
}
page-gallery-none = Aún no hay ningún mundo llamado «{ $words }».
page-gallery-used = En uso
page-gallery-make = Crear un mundo
page-gallery-make-help = Arrastra cosas y juega
page-gallery-more = Más sobre { $title }
page-gallery-needs = Necesita { $what }: { $robots }
page-gallery-robots = { $count } robots
page-gallery-all-robots = todos los robots
page-gallery-easy = Fácil
page-gallery-medium = Medio
page-gallery-tricky = Difícil
page-gallery-group-games = Juegos
page-gallery-group-drive = Conducir
page-gallery-group-obstacles = Obstáculos
page-gallery-group-lines = Líneas
page-gallery-group-tags = Cámara y etiquetas
page-gallery-group-faces = Caras y emociones
page-gallery-group-several = Varios robots
page-gallery-group-empty = Vacío
