# Lo que la página de inicio ofrece a docentes.

page-teachers-about = La clase funciona en este ordenador. Sin cuentas, y el alumnado no instala nada.
page-teachers-elsewhere = Las clases están en el ordenador que ejecuta LearnBlock: abre allí esta página para empezar una.
page-teachers-topics = Antes y después de la clase

## Clases

page-teachers-classes = Mis clases
page-teachers-none = Tus clases aparecen aquí. Empieza la primera o abre el archivo de una clase que hayas preparado.
page-teachers-open-file = Abrir un archivo de clase
page-teachers-is-open = Abierta
page-teachers-is-closed = Cerrada
# $count es un número.
page-teachers-pupils = { $count ->
        [0] Aún no hay nadie
        [one] { $count } persona
       *[other] { $count } personas
    }
# $day es un día, como «hoy» o «12 de noviembre».
page-teachers-used = último uso: { $day }
# $lesson es el título de una lección.
page-teachers-begins = empieza con { $lesson }
page-teachers-open = Abrir
page-teachers-opening = Abriendo…
page-teachers-close = Cerrar
page-teachers-closing = Guardando todo…
page-teachers-wall = Ir al panel
page-teachers-download = Descargar la clase
page-teachers-delete = Borrar
page-teachers-delete-title = ¿Borrar la clase { $title }?
page-teachers-delete-text = Se borra de este ordenador todo lo que ha hecho el alumnado, y sus nombres. No se puede deshacer.
page-teachers-delete-type = Escribe { $title } para borrarla
page-teachers-keep = Conservar

## Empezar una

page-teachers-start = Empezar una clase
page-teachers-name = Nombre, como 7b
page-teachers-lesson = Primera lección
page-teachers-no-lesson = Ninguna
page-teachers-blocks = Bloques en los proyectos propios del alumnado
page-teachers-start-button = Empezar la clase
page-teachers-next = Después ves el panel, con la palabra de entrada, la dirección y un código QR para el proyector. Cada lección muestra sus bloques.

## Lo que se guarda

page-teachers-kept = Qué se guarda de cada niño
page-teachers-kept-names = El nombre y cuatro dibujos, que sustituyen a una contraseña. Nunca apellidos, correo ni dispositivo.
page-teachers-kept-work = Programas, ejecuciones y estrellas.
page-teachers-kept-here = Solo en este ordenador. No se envía nada, y ninguna IA juzga a nadie.
page-teachers-kept-until = Hasta que lo borres: a una persona, en el panel; una clase entera, aquí.
