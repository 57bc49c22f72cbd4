tabs-too-many = Un proyecto puede tener { $limit } robots como máximo.
tabs-one-real = En { $robot }, que es un robot real, solo un robot puede ejecutar un programa. Elige un robot simulado para tener más.
tabs-last = Un proyecto necesita al menos un robot.
tabs-none-closed = No hay ningún robot cerrado que se pueda recuperar.
tabs-wrong-name = Un robot no puede llamarse '{ $name }'. Elige otro nombre de { $limit } letras, cifras, espacios y guiones como máximo, que no tenga otro robot.
tabs-no-such = Este proyecto no tiene ningún robot '{ $name }'.
tabs-error = El programa de '{ $name }' no puede ejecutarse: { $problem }
