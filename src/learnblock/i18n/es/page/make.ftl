# Crear los bloques de un programa.

page-make-button = Crear un bloque
page-make-none = Pon nombre a lo que repites.
page-make-here = En este proyecto
page-make-change = Cambiar este bloque…
page-make-title-change = Cambiar un bloque
page-make-used = Se usa así
page-make-defined = Aquí dices lo que hace
page-make-name = Nombre
page-make-placeholder = mi_bloque
# $name es lo que se ha escrito, o el nombre que resulta de ello.
page-make-unnamed = Dale un nombre, como «bailar» o «ir a casa».
page-make-reserved = «{ $name }» es una palabra del lenguaje. Elige otro nombre.
page-make-taken = Ya hay algo que se llama «{ $name }». Elige otro nombre.
page-make-in-texts = En el programa se llama «{ $name }», porque los nombres no llevan espacios ni signos.
page-make-inputs = Entradas
page-make-input-name = Nombre de la entrada { $number }
page-make-kind = Tipo de { $name }
page-make-kind-number = Número
page-make-kind-text = Texto
page-make-kind-truth = Sí o no
# Los nombres de las entradas nuevas: solo letras, dígitos y _.
page-make-name-number = número
page-make-name-text = texto
page-make-name-truth = opción
page-make-first-text = hola
page-make-sample = Primer valor de { $name }
page-make-no-number = Escribe un número.
page-make-yes = sí
page-make-no = no
page-make-up = Subir { $name }
page-make-delete = Borrar { $name }
page-make-it = Crear
page-make-change-it = Cambiar
