# Importar programas del LearnBlock original.

## El archivo

import-too-large = El archivo ocupa { $size } bytes, pero un proyecto del LearnBlock original puede tener { $limit } como mucho.
import-too-many = El archivo tiene más de { $limit } valores. Ningún proyecto del LearnBlock original tiene tantos.
import-too-deep = Los valores de este archivo están anidados demasiado hondo para un proyecto del LearnBlock original.
import-damaged = Este archivo está dañado o no es un proyecto del LearnBlock original: no se puede leer en el byte { $byte }.
import-forbidden = Este archivo contiene '{ $what }' antes del byte { $byte }, algo que no tiene ningún proyecto del LearnBlock original. No se ha ejecutado nada de él; no lo abras con otros programas.
import-wrong-project = Este archivo no es un proyecto del LearnBlock original: '{ $place }' falta o tiene otra forma.
import-nested = Los bloques de este proyecto están anidados a más de { $limit } niveles. Divide el programa en funciones en el LearnBlock original.

## Lo que cambia

import-old-name = La habilidad '{ $name }' se llama ahora '{ $today }'.
import-renamed = El nombre '{ $name }' pasa a ser '{ $new }', porque los nombres llevan letras, cifras y '_'.
import-print-brackets = 'print' lleva ahora paréntesis.
import-degrees = En '{ $skill }', { $radians } radianes por segundo pasan a ser { $degrees } grados por segundo.
import-unset = La variable '{ $name }' no tenía ningún valor al principio. Ahora vale 0.
import-twice = Hay más de un '{ $name }'. Se usa el primero; los bloques de los demás quedan sueltos.
import-heard = Ahora el mensaje lo escucha el evento 'when { $event } = { $condition }'. Pon en él lo que deba empezar con el mensaje.
import-library = El proyecto usaba la biblioteca '{ $name }'. Sus funciones son ahora parte del programa.

## Lo que falta

import-unknown-skill = No hay ninguna habilidad '{ $skill }'. Como instrucción pasa a ser un comentario; como condición, False.
import-unread-line = '{ $text }' no se puede leer. Como instrucción pasa a ser un comentario; como condición, False.
import-no-condition = Un '{ $name }' no tenía condición. Pasa a ser False.
import-no-if = Un '{ $name }' no tenía ningún 'if' encima. Pasa a ser un 'if'.
import-left-out = El bloque '{ $name }' está unido en círculo o a dos bloques. Se ha dejado fuera.
import-no-library = La biblioteca '{ $name }' no está junto al proyecto. Copia ahí su carpeta y vuelve a importar el proyecto.
import-no-function = La función '{ $name }' no está en el proyecto. Ahora es una función vacía: complétala.
import-no-event = El evento '{ $name }' no está en el proyecto. Ahora es un evento vacío: complétalo.
import-argument-dropped = '{ $skill }' ya no lleva el valor { $value }.
import-argument-missing = '{ $skill }' no tenía en '{ $name }' un valor que se pueda leer. Ahora vale { $value }.
import-python-only = '{ $name }' tiene funciones en Python que usan el robot del LearnBlock original: { $functions }. Escríbelas de nuevo como bloques propios.
import-no-block = El archivo describe un bloque '{ $name }', pero no tiene ninguna función para él.
import-not-readable = '{ $name }' no se puede leer y se ha dejado fuera: { $reason }
import-not-only-functions = La biblioteca contiene más que funciones. En su lugar es un programa.
import-not-a-library = Las funciones no pueden ser una biblioteca: { $reason } En su lugar son un programa.

## Archivos y carpetas

# $name is the name of a file.
import-only-program = '{ $name }' no puede ser una biblioteca, porque sus funciones solo pueden usarse en un programa. Abre este archivo solo para usarlo como programa.
import-type = LearnBlock no puede importar archivos de este tipo. Elige un archivo .blockProject o .lb, o una carpeta con archivos así.
import-nothing = No hay nada que importar en { $folder }: no tiene archivos .blockProject ni .lb.
import-no-functions = Este archivo no tiene funciones.
import-exists = { $file } ya existe. Usa --replace para reemplazarlo, o --output para escribir en otra carpeta.
import-imported = { $file }: importado como { $target }
import-changed = cambia:
import-missing = no se ha podido traer:
