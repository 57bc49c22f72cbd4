# A class in one room.

## Opening

# $title is the name of the class, $address where pupils come in, $word the join word, $wall and
# $projector are addresses for the teacher.
class-opened =
    Class { $title } is open. Press Ctrl-C to save everything and close it.

      Pupils open  { $address }
      Join word    { $word }

      Your wall    { $wall }
      Projector    { $projector }

    The address of your wall holds your key: don't show it to pupils.
class-opened-at-hub = The class { $title } is open at { $address }. Ctrl-C saves everything and closes it.
class-closing = Class { $title } closes. Saving everything...
class-ended = Everything is saved. Class { $title } is closed.
class-ended-by-force = Class { $title } is closed. A pupil's LearnBlock did not answer and was ended; what it showed as saved is there.
class-bad-title = The name of a class is 1 to 40 letters, digits, spaces, '.', '_' or '-', such as 7b.
class-already-open = Class { $title } is open already, in another LearnBlock.
# $seconds is a number.
class-does-not-end = Class { $title } has not closed after { $seconds } seconds. Wait a moment and try again; nothing that was saved is lost.
# $reason is what the class said last, in any language.
class-not-started = Class { $title } could not be opened: { $reason }
class-exists = There is already a class { $title }. Rename or delete it first; what this file contains is not taken in.
class-file-damaged = This is not the file of a class, or it is damaged. Choose a file that ends with .lbclass.
# $most is a number.
class-file-too-many = It has more than { $most } files. Copy the folder of the class instead.
# $most is a number of gigabytes.
class-file-too-large = It has more than { $most } GB. Copy the folder of the class instead.
class-unknown = There is no class { $title } in { $folder }.
class-delete = Delete class { $title } with everything that its pupils have made? This can't be undone.
class-deleted = Class { $title } is deleted.
class-not-on-windows = A class needs Linux or macOS on the teacher's computer. On Windows use WSL; pupils can have any device.
class-no-cryptography = HTTPS needs an add-on that is not installed. Leave out --tls, or install it with: { $command }
# $variable is the name of an environment variable.
class-no-hub = With --hub, only JupyterHub can start a class, as a service: the environment variable { $variable } is missing.
class-login-again = This login was not begun here. Open the address of the class again.
# $file is the path of a file, $reason a technical text in English.
class-damaged = { $file } is damaged: { $reason }. Restore it from a backup, or choose another --folder.
class-newer = { $file } was made by a newer LearnBlock. Update this one.

## Joining

class-wrong-word = That is not the join word. It is on the board.
class-no-name = Type your first name: 1 to { $most } characters that begin with a letter.
# $name has several words.
class-only-first-name = Only your first name, please, without a surname. Is all of { $name } your first name?
# $character is the number of a character, such as U+202E.
class-hidden-character = Your name has a character that can't be seen ({ $character }). Delete it and type it again.
class-wrong-pictures = The name and the pictures don't belong together. Try again, or ask your teacher for new pictures.
# $seconds is a number.
class-wait = That was wrong too often. Wait { $seconds } { $seconds ->
        [one] second
       *[other] seconds
    } and try again.
# $seconds is a number.
class-join-wait = Many have just joined from your network. Wait { $seconds } { $seconds ->
        [one] second
       *[other] seconds
    } and try again.
class-asks-teacher = Your teacher has to let you in. Tell your teacher, who sees a question on the wall, and try again.
# $most is a number.
class-name-taken = There are already { $most } with the name { $name }. Add a letter of your surname.
class-closed = New pupils can't join now. Ask your teacher.
class-full = The class is full: it has { $most } pupils.

## In class

class-not-yours = In class, this is for your teacher.
class-only-look = You are only looking. Ask the pupil to let you write.
class-too-fast = That was too often. Wait a moment and try again.
# $most is a number.
class-too-many-pages = You have { $most } pages of this class open. Close one of them.
class-uploading = Another file is still being opened. Wait until it is done.
class-no-pupil = This pupil is no longer in the class.
# $limit is a number of kB.
class-lesson-first = New pupils of this class begin with this lesson, so it can't be deleted while the class is open.
class-lesson-too-large = This lesson is too large to be handed out: the limit is { $limit } kB. Use smaller pictures.
class-not-handed-in = This pupil has not handed in this step.
class-too-many-hand-ins = More than { $most } steps can't be handed in.
class-checking = Hand-ins are being checked. Wait until the check is done, or stop it.
class-check-died = The check was interrupted. Finished results are kept: check again to continue.
class-ends = The class is closing. Your work is saved.
class-server-silent = Your place in class is not ready yet. Try again in a moment.
class-server-failed = Your place in class could not be prepared: { $reason }

## Classmates

class-classmate-away = This classmate isn't here at the moment. Choose someone else.
# $name is a classmate.
class-classmate-declined = { $name } has just said no. Ask again in a minute.

## Playing together

class-pair-off = Playing together is switched off. Ask your teacher.
class-pair-over = Your teacher has switched playing together off.
class-pair-already = You are playing with a classmate, or have invited one. Leave first.
class-pair-busy = { $name } is playing with another classmate. Ask again later.
class-pair-declined = { $name } does not want to play now.
class-pair-silence = { $name } has not answered your invitation.
class-pair-no-invitation = This invitation has been taken back.
class-pair-no-project = Open a project with two robots first, then invite.
class-pair-lesson = In a lesson you work alone. Open a project of your own, then invite.
class-pair-one-robot = Your project has only one program. Add a second robot, which your classmate's program will drive.
class-pair-left = { $name } no longer plays with you.
class-pair-no-world = The project that you were playing in can't be opened any more.
class-pair-away = { $name }'s page does not show your world at the moment. Wait a moment, or stop playing together.
class-pair-silent = Your LearnBlock does not answer. Try again in a moment.
class-pair-no-answer = { $name }'s program has not arrived. Try again in a moment.
class-pair-mistakes = { $name } has no program open, or one with mistakes. Run again once it is mended.
class-pair-mistakes-own = { $name } wants to start: open your program, and mend its mistakes.
# $robot is the name of a robot.
class-pair-unfit = { $name }'s program can't run on the robot { $robot }. Choose another kind of robot, or ask for another program.
# $robot is the name of a robot.
class-pair-unfit-own = Your program can't run on the robot { $robot }. Use only blocks that this robot has.
class-pair-only-keys = In a classmate's world you can only press keys.

## Showing programs

# $project is the name of a project.
class-show-teacher = Your teacher sees on the wall that you show “{ $project }”.
class-show-seen = Your teacher is looking at “{ $project }”.
# $name is a classmate, $project the name of a project.
class-show-classmate = { $name } can open a copy of “{ $project }” now.
class-show-opened = { $name } has opened a copy of “{ $project }”.
class-show-declined = { $name } does not want to look now.
class-show-busy = { $name } has many programs to look at. Try again later.
class-show-gone = This program is no longer offered.
class-show-lesson = In a lesson you work alone. Open a project of your own, then show it.
class-show-no-project = Open a project first, then show it.
class-show-off = Showing programs to classmates is switched off. Ask your teacher.
