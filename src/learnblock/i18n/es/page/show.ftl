# Enseñar un programa a alguien de clase, en las páginas del alumnado.

page-show-title = Enseñar a alguien de clase
page-show-how = Esa persona podrá abrir una copia. La tuya se queda como está.
page-show-none-here = En este momento no hay nadie más de tu clase.
page-show-offer = { $name } te enseña «{ $project }».
page-show-open = Abrir
page-show-not-now = Ahora no
