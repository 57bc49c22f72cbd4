# Una clase en un aula.

## Abrir

class-opened =
    La clase { $title } está abierta. Pulsa Ctrl-C para guardarlo todo y cerrarla.

      El alumnado abre     { $address }
      Palabra para entrar  { $word }

      Tu panel             { $wall }
      Proyector            { $projector }

    La dirección de tu panel contiene tu llave: no se la enseñes al alumnado.
class-opened-at-hub = La clase { $title } está abierta en { $address }. Ctrl-C lo guarda todo y la cierra.
class-closing = La clase { $title } se cierra. Guardando todo...
class-ended = Todo está guardado. La clase { $title } está cerrada.
class-ended-by-force = La clase { $title } está cerrada. El LearnBlock de algún alumno no respondía y se ha terminado a la fuerza; lo que mostraba como guardado está ahí.
class-bad-title = El nombre de una clase tiene de 1 a 40 letras, cifras, espacios, '.', '_' o '-', por ejemplo 7b.
class-already-open = La clase { $title } ya está abierta en otro LearnBlock.
# $seconds es un número.
class-does-not-end = La clase { $title } no se ha cerrado en { $seconds } segundos. Espera un momento y vuelve a intentarlo; no se pierde nada de lo guardado.
# $reason es lo último que dijo la clase, en cualquier idioma.
class-not-started = No se ha podido abrir la clase { $title }: { $reason }
class-exists = Ya hay una clase { $title }. Cámbiale el nombre o bórrala primero; no se ha añadido nada de este archivo.
class-file-damaged = Este archivo no es de una clase o está dañado. Elige uno que termine en .lbclass.
# $most es un número.
class-file-too-many = Tiene más de { $most } archivos. Copia la carpeta de la clase.
# $most es un número de gigabytes.
class-file-too-large = Tiene más de { $most } GB. Copia la carpeta de la clase.
class-unknown = No hay ninguna clase { $title } en { $folder }.
class-delete = ¿Eliminar la clase { $title } con todo lo que ha hecho su alumnado? No se puede deshacer.
class-deleted = La clase { $title } se ha eliminado.
class-not-on-windows = Para abrir una clase hace falta Linux o macOS en el ordenador del profesorado. En Windows usa WSL; el alumnado puede tener cualquier dispositivo.
class-no-cryptography = HTTPS necesita un complemento que no está instalado. Quita --tls, o instálalo con: { $command }
class-no-hub = Con --hub solo JupyterHub abre una clase, como servicio: falta { $variable } en el entorno.
class-login-again = Este inicio de sesión no empezó aquí. Abre otra vez la dirección de la clase.
class-damaged = { $file } está dañado: { $reason }. Recupéralo de una copia de seguridad o elige otra --folder.
class-newer = { $file } lo creó un LearnBlock más nuevo. Actualiza este.

## Entrar

class-wrong-word = Esa no es la palabra para entrar. Está en la pizarra.
class-no-name = Escribe tu nombre: de 1 a { $most } caracteres, y el primero una letra.
class-only-first-name = Solo tu nombre, por favor, sin apellidos. ¿Todo esto es tu nombre: { $name }?
class-hidden-character = Tu nombre tiene un carácter que no se ve ({ $character }). Bórralo y escríbelo de nuevo.
class-wrong-pictures = El nombre y los dibujos no van juntos. Prueba otra vez o pide dibujos nuevos a tu profe.
class-wait = Ha fallado demasiadas veces. Espera { $seconds } { $seconds ->
        [one] segundo
       *[other] segundos
    } y prueba otra vez.
class-join-wait = Acaban de entrar muchas personas desde tu red. Espera { $seconds } { $seconds ->
        [one] segundo
       *[other] segundos
    } y prueba otra vez.
class-asks-teacher = Tu profe tiene que dejarte entrar. Avísale: verá una pregunta en su panel. Después prueba otra vez.
class-name-taken = Ya hay { $most } personas que se llaman { $name }. Añade una letra de tu apellido.
class-closed = Ahora no puede entrar nadie nuevo. Pregunta a tu profe.
class-full = La clase está llena: tiene { $most } alumnos.

## En clase

class-not-yours = En clase, esto es cosa de tu profe.
class-only-look = Solo estás mirando. Pide a la otra persona que te deje escribir.
class-too-fast = Demasiado seguido. Espera un momento y prueba otra vez.
class-too-many-pages = Tienes { $most } páginas de esta clase abiertas. Cierra una.
class-uploading = Todavía se está abriendo otro archivo. Espera a que termine.
class-no-pupil = Esta persona ya no está en la clase.
class-lesson-first = Quien se une a esta clase empieza con esta lección: no se puede eliminar mientras la clase esté abierta.
class-lesson-too-large = Esta lección es demasiado grande para repartirla: el límite es { $limit } kB. Usa imágenes más pequeñas.
class-not-handed-in = Esta persona no ha entregado este paso.
class-too-many-hand-ins = No se pueden entregar más de { $most } pasos.
class-checking = Se están comprobando entregas. Espera a que termine la comprobación o detenla.
class-check-died = La comprobación se ha interrumpido. Lo terminado se conserva: comprueba otra vez para seguir.
class-ends = La clase se está cerrando. Tu trabajo está guardado.
class-server-silent = Tu sitio en la clase aún no está listo. Prueba otra vez dentro de un momento.
class-server-failed = No se pudo preparar tu sitio en la clase: { $reason }

## Compañeros de clase

class-classmate-away = Esa persona no está conectada en este momento. Elige a otra.
class-classmate-declined = { $name } acaba de decir que no. Pregunta otra vez dentro de un minuto.

## Jugar en pareja

class-pair-off = Jugar en pareja está desactivado. Pregunta a tu profe.
class-pair-over = Tu profe ha desactivado jugar en pareja.
class-pair-already = Ya juegas con alguien de clase o has enviado una invitación. Sal primero.
class-pair-busy = { $name } está jugando con otra persona. Pregunta más tarde.
class-pair-declined = { $name } no quiere jugar ahora.
class-pair-silence = { $name } no ha respondido a tu invitación.
class-pair-no-invitation = Esta invitación ya se ha retirado.
class-pair-no-project = Abre primero un proyecto con dos robots y después invita.
class-pair-lesson = En una lección trabajas por tu cuenta. Abre un proyecto tuyo y después invita.
class-pair-one-robot = Tu proyecto solo tiene un programa. Añade otro robot: lo moverá el programa de la otra persona.
class-pair-left = { $name } ya no juega contigo.
class-pair-no-world = El proyecto en el que jugabais ya no se puede abrir.
class-pair-away = La página de { $name } no muestra tu mundo en este momento. Espera un poco o deja de jugar en pareja.
class-pair-silent = Tu LearnBlock no responde. Prueba otra vez dentro de un momento.
class-pair-no-answer = El programa de { $name } no ha llegado. Prueba otra vez dentro de un momento.
class-pair-mistakes = { $name } no tiene ningún programa abierto, o el que tiene contiene errores. Ejecuta otra vez cuando esté corregido.
class-pair-mistakes-own = { $name } quiere empezar: abre tu programa y corrige sus errores.
class-pair-unfit = El programa de { $name } no puede funcionar en el robot { $robot }. Elige otro tipo de robot o pide otro programa.
class-pair-unfit-own = Tu programa no puede funcionar en el robot { $robot }. Usa solo bloques que tenga ese robot.
class-pair-only-keys = En el mundo de otra persona solo puedes pulsar teclas.

## Enseñar programas

class-show-teacher = Tu profe ve en su panel que le enseñas «{ $project }».
class-show-seen = Tu profe está mirando «{ $project }».
class-show-classmate = { $name } ya puede abrir una copia de «{ $project }».
class-show-opened = { $name } ha abierto una copia de «{ $project }».
class-show-declined = { $name } no quiere mirarlo ahora.
class-show-busy = { $name } tiene muchos programas por mirar. Prueba más tarde.
class-show-gone = Este programa ya no se puede abrir.
class-show-lesson = En una lección trabajas por tu cuenta. Abre un proyecto tuyo y después enséñalo.
class-show-no-project = Abre primero un proyecto y después enséñalo.
class-show-off = Enseñar programas a la clase está desactivado. Pregunta a tu profe.
