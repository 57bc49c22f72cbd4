# Files in TOML: worlds, simulated robots, block sets, libraries and settings.

toml-broken = Esto no es TOML válido: { $reason }.
toml-too-deep = Está anidado a demasiada profundidad.

toml-wrong-value = { $place } es { $value }, pero debe ser { $allowed }.
toml-wrong-value-like = { toml-wrong-value } ¿Querías decir '{ $suggestion }'?
toml-missing-value = Falta la clave '{ $key }' en { $place }. Debe ser { $allowed }.
# Una tabla con claves libres, como un texto por idioma.
toml-wrong-key = Cada clave de { $place } debe ser { $allowed }.
toml-wrong-entry = Cada valor de { $place } debe ser { $allowed }.
toml-single-table = '{ $name }' es una sola tabla, pero puede haber varias. Escribe su cabecera como [[{ $name }]].

toml-number = un número de { $least } a { $most }
toml-whole-number = un número entero de { $least } a { $most }
toml-text = un texto de { $least } a { $most } caracteres
toml-plain-text = texto
toml-tagged = una tabla cuyo '{ $key }' es { $allowed }
toml-boolean = true o false
toml-table = una tabla de claves y valores
toml-choice = { $count ->
        [1] { $choices }
       *[other] uno de { $choices }
    }
toml-either = { $first } o { $second }
toml-list = una lista de { $least } a { $most } elementos, cada uno { $item }
toml-list-exactly = una lista de { $count } elementos, cada uno { $item }
toml-items = [{ $items }]
toml-with-note = { $allowed } ({ $note })
