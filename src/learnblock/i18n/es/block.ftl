# Los bloques: valores de sus campos, tipos y configuraciones.

block-expects-number = Escribe un número.
block-expects-text = Escribe un texto entre comillas.
block-expects-truth = Escribe True o False.
block-expects-list = Escribe una lista.
block-expects-tag = Escribe el número o el nombre de una etiqueta.
block-expects-colour = Escribe un color como "#ff8800".
block-expects-range = Elige un número de { $least } a { $most }.
block-expects-choice = Elige uno de estos: { $choices }.

block-type = { $type }
block-type-with-range = { $type } de { $least } a { $most }

block-range-ends = Los extremos de un intervalo tienen que ser números.
block-range-order = El primer número tiene que ser menor que el segundo.
block-range-step = El paso tiene que ser mayor que cero y caber en el intervalo.

block-unknown-hint = { $hint } no tiene campo en un bloque. Escribe float, int, str, bool, list, Colour, Angle, TagName, Annotated[float, Range(0, 100)] o Literal["a", "b"].
block-hint-range-not-number = { $hint } tiene un intervalo, pero solo los números pueden tenerlo.
block-hint-range-form = { $hint } no es un intervalo. Escribe Range(0, 100) o Range(0, 10, step=1).
block-hint-range = { $hint } no es válido. { $problem }
block-hint-range-number = { $hint } en un Range no es un número.
block-hint-choices = Literal[{ $hint }] no es válido. Escribe como mucho { $most } opciones distintas de una línea cada una, por ejemplo Literal["slow", "fast"].

block-file-unreadable = No se puede leer { $file }: { $reason }
block-plugin-unreadable = No se puede leer el plugin '{ $plugin }': { $reason }
block-plugin-missing = El módulo { $module } del plugin '{ $plugin }' no está instalado como código de Python. Reinstala el plugin.
block-broken-file = { $file }, línea { $line }: { $reason }

block-not-utf-8 = Este archivo no es UTF-8. Guárdalo como UTF-8.
block-where-block = el bloque '{ $name }'
block-where-nameless-block = el bloque
block-where-parameter = el parámetro '{ $name }' en { $block }
block-where-nameless-parameter = un parámetro en { $block }
block-duplicate-key = La clave '{ $key }' aparece dos veces. Deja una.
block-not-object = { $value } tiene que ser un objeto {"{...}"}, porque describe { $where }.
block-unknown-key = No existe la clave '{ $key }' para { $where }. Claves: { $known }.
block-unknown-key-like = No existe la clave '{ $key }' para { $where }. ¿Querías decir '{ $suggestion }'?
block-missing-key = Falta la clave '{ $key }' para { $where }. { $key ->
    [type] Es la clase del bloque o del parámetro, por ejemplo "motor" o "float".
    [category] Es la pestaña de la paleta, por ejemplo "Base".
    [name] Es el nombre de la función de Python o de su parámetro.
   *[shape] Escribe ["blockVertical"] para una instrucción o ["blockLeft"] para un valor.
}
block-unknown-value = En { $where }, '{ $key }' es { $value }. Escribe uno de estos: { $known }.
block-unknown-value-like = En { $where }, '{ $key }' es { $value }. ¿Querías decir '{ $suggestion }'?
block-not-text = En { $where }, '{ $key }' es { $value }. Escribe algún texto entre comillas dobles.
block-bad-name = Python no puede usar el nombre '{ $value }'. Usa letras, cifras y _, por ejemplo turn_left.
block-empty-shape = En { $where }, 'shape' está vacío. Escribe ["blockVertical"] para una instrucción o ["blockLeft"] para un valor.
block-two-shapes = En { $where }, 'shape' es a la vez una instrucción y un valor. Escribe ["blockVertical"] para una instrucción o ["blockLeft"] para un valor.
block-not-translations = En { $where }, '{ $key }' es { $value }. Escribe {"{\"EN\": \"...\", \"ES\": \"...\"}"}.
block-bad-language = { $value }, en '{ $key }' para { $where }, no es un idioma. Escribe un código como EN, ES o PT-BR.
block-duplicate-language = El idioma { $language } aparece dos veces en '{ $key }' para { $where }. Deja uno.
block-bad-need = { $value }, en 'needs' para { $where }, no es ni un sentido ni un dispositivo. Escribe un sentido como heading, un dispositivo como Base, o uno con su clave, como JointMotor:CAMERA o RGBLed:{"{"}slot{"}"}.
block-not-list = En { $where }, '{ $key }' es { $value }. Escribe una lista, por ejemplo { $example }.
block-bad-default = El valor por defecto { $value } para { $where } no encaja en el tipo { $type }. { $type ->
    [float] Escribe un número, por ejemplo 0.5.
    [int] Escribe un número entero, por ejemplo 3.
    [boolean] Escribe true o false.
    [list] Escribe una lista, por ejemplo [1, 2].
    [colour] Escribe un color, por ejemplo "#ff8800".
    [angle] Escribe grados, por ejemplo 90.
    [apriltext] Escribe el número de una etiqueta, por ejemplo 8, o su nombre, por ejemplo "ball".
   *[other] Escribe un texto entre comillas dobles, por ejemplo "Up".
}
block-bad-range = En { $where }, 'range' es { $value }. { $problem }
block-range-form = Escribe [0, 100], o [0, 10, 1] con un paso.
block-range-not-number = Solo los números pueden tener un intervalo.
block-choices-type = En { $where }, 'choices' necesita el tipo "choice" o "string".
block-bad-choices = En { $where }, 'choices' es { $value }. Escribe como mucho { $most } opciones distintas de una línea cada una, por ejemplo ["slow", "fast"].
block-unknown-choice = En { $where }, 'choiceNames' traduce { $value }, que no es ninguna de sus opciones.
block-unknown-choice-like = En { $where }, 'choiceNames' traduce { $value }, que no es ninguna de sus opciones. ¿Querías decir '{ $suggestion }'?
block-not-directions = En { $where }, 'directions' es { $value }. Escribe {"{\"positive\": {\"ES\": \"derecha\"}, \"negative\": {\"ES\": \"izquierda\"}}"}.
block-directions-not-number = Solo los números pueden tener 'directions', y { $where } no es un número. Quítalas o cambia su tipo.
block-not-choice-names = En { $where }, 'choiceNames' es { $value }. Escribe {"{\"slow\": {\"ES\": \"lento\"}}"}.
block-duplicate-block = Ya hay un bloque '{ $name }' más arriba. Elige otro nombre.
block-duplicate-parameter = Ya hay un parámetro '{ $name }' en { $where } más arriba. Elige otro nombre.
block-missing-default = '{ $name }' en { $where } necesita un valor por defecto, porque '{ $optional }', que va antes, lo tiene.
