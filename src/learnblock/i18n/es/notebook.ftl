# Robots en cuadernos.

# $call es un método del robot, como show.
notebook-none = 'robot.{ $call }' funciona en un cuaderno, y este programa no se ejecuta en ninguno. Ejecútalo en Jupyter o en los cuadernos de VS Code.
# $world es el nombre de un mundo.
notebook-new-world = Este robot está en un mundo nuevo ('{ $world }'). Los robots anteriores siguen en los suyos.
# $robot es el nombre de un robot, como ev3.
notebook-disconnected = Se ha cerrado la conexión anterior con '{ $robot }', porque un robot solo tiene una.
# Una línea de una celda, en "la línea 4 de [2] dice ...". $cell es el número de la celda.
notebook-line = { $line } de [{ $cell }]
# La primera celda con un robot se ha ejecutado antes de que LearnBlock pudiera anotar sus pasos.
notebook-not-noted = LearnBlock anota lo que hacen las celdas a partir de la siguiente al primer Robot(). Para preguntar también por esa, ejecuta '%load_ext learnblock.notebook' en una celda anterior.
# El título de una página que muestra la ejecución de una celda. $cell es su número.
notebook-cell = Celda [{ $cell }]
