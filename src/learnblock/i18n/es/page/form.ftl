# Campos de los formularios.

page-form-none = ninguno
page-form-wants-number = Escribe un número de { $least } a { $most }.
page-form-wants-whole = Escribe un número entero de { $least } a { $most }.
page-form-wants-text = Escribe algo.
page-form-mix = Color personalizado
page-form-remove = Eliminar: { $title }
