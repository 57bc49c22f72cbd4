# La tabla de variables y eventos.

page-variables-title = Variables del programa
page-variables-name = Nombre
page-variables-value = Valor
page-variables-stack = En { $functions }
page-variables-local = En esta función
page-variables-shared = Globales
page-variables-open = Mostrar las partes de { $name }
page-variables-whens = Evento
page-variables-state = Estado
page-variables-time = Activo desde hace
page-variables-active = ● activo
page-variables-inactive = ○ en espera
page-variables-nothing = Ejecuta un programa para ver sus variables.
page-variables-changes = Cambios
page-variables-change-before = Ir al cambio anterior de { $name }
page-variables-change-after = Ir al cambio siguiente de { $name }
