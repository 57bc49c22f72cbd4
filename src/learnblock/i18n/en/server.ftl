# The server: where it listens, who may use it, and messages from pages that it can't carry out.

## Starting

# $address is the address of the page.
server-started =
    LearnBlock is running at { $address }
    Press Ctrl-C to stop it.
# The user has started it before; $address is the address of its page.
server-running =
    LearnBlock is already running. Its page is at { $address }
    To end that one and start a new one instead, use --take-over.
# $address is the address of a page.
server-silent = The LearnBlock at { $address } does not answer. Use --take-over to end it and start a new one.
# $reason is the system's text.
server-cannot-listen = LearnBlock can't listen at { $host }, port { $port }: { $reason }. Choose another --port.
server-cannot-listen-socket = LearnBlock can't listen at { $path }: { $reason }.
server-already-listening = Another LearnBlock is listening at { $path }.
# $variable is the name of an environment variable.
server-token-wrong = { $variable } can only contain letters, digits, '-', '_', '.' and '~'.
server-no-window = A window needs an add-on that is not installed. Leave out --window to use the browser, or install it with: { $command }

# $free lists what programs can do, such as "Use the network, Start other programs".
server-not-contained =
    Other computers can use this page, and on this computer nothing contains all that their programs do: { $free }.
    Run only programs that you trust. The reasons: learnblock doctor, or "What programs may do" in the page's help menu.

## One writer per folder

# $process is a number, $since a date and time, $address the address of its page.
server-owner = process { $process }, since { $since }, at { $address }
# $computer is the name of another computer that shares the folder.
server-owner-elsewhere = process { $process } on { $computer }, since { $since }, at { $address }
server-owner-unknown = a process that has just started or belongs to another user
# $owner is one of the above.
server-folder-used = Another LearnBlock is using the folder { $folder }: { $owner }.
# $used is the sentence above.
server-folder-refused = { $used } Use --take-over to let it save everything and end, --read-only to open and run projects without saving, or --projects for another folder.
server-folder-waiting = Waiting up to { $seconds } seconds for the other LearnBlock to save everything and end: { $owner }
server-folder-kept = The other LearnBlock has not ended: { $owner }. It still has the folder { $folder }. End that process yourself and start LearnBlock again, or use --read-only.
server-folder-unlocked = LearnBlock can't lock the folder { $folder } ({ $reason }), so it can't tell whether another LearnBlock is using it. Open these projects in only one LearnBlock at a time.
server-taken-over = Another LearnBlock takes over this folder. Saving everything...
server-ends-late = Something in LearnBlock hangs. Saving everything, then ending it now.
server-ends-at-once = Saving everything, then ending at once.
server-reading = Read only: you can open and run projects, but changes are not saved.
server-reading-beside = Read only: another LearnBlock is using these projects ({ $owner }). You can open and run them, but not change them here.
server-read-only = Nothing can be changed here: this LearnBlock only reads. To make changes, start LearnBlock without --read-only.
# $name is the name of a file.
server-open-read-only = Opening '{ $name }' would copy it into the projects folder. Leave out --read-only.

## Answers to a browser

# The title of the page below.
server-incomplete-address-title = This address is incomplete
server-incomplete-address = The address of this page ends in ?token= and a long word. To open it, run learnblock once more, or use the whole address that LearnBlock printed when it started.
server-wrong-address = LearnBlock does not accept this address or this page. Open the address that LearnBlock printed; behind a proxy, start LearnBlock with --allow-host NAME.
server-not-built-title = The page has not been built
server-not-built = This LearnBlock runs from its sources, without a built page. Build the page with Node.js, and reload:
server-no-picture = There is no such picture.

## Messages from a page

# $reason is a technical text in English.
server-mistake = Something went wrong in LearnBlock: { $reason }
server-no-project = No project is open. Open a project first.
server-only-in-class = Only the server of a class can send this.
server-no-class = This page is not in a class, so you can't hand in your work.
server-too-deep = This is nested too deeply.
server-message-too-long = A message of { $count } characters is too long.
server-message-unknown = LearnBlock doesn't know this message: { $reason }
server-text-too-long = This program is too long: the limit is { $limit } characters.
# $count is how many projects this page, or this person, has just made.
server-too-many-projects = You have just made { $count } projects. Wait { $seconds } seconds before making another.
# $most is a number.
server-too-many-runs = The programs of { $most } projects are running. Stop one of them first.
server-message-broken = This message is nested too deeply, or is not text.
# $problem is a sentence.
server-block-set-file = The file '{ $name }' is not a block set. { $problem }
server-world-exists = You already have a world '{ $name }'. Choose another name, or save again to replace it.

## Programs that may use the network

server-classes-only-here = Classes are on the computer that runs LearnBlock: open the page there.
server-network-only-here = Only a page on the computer that runs LearnBlock can change this. Behind a proxy, use settings.toml.
# $folder is the path of a folder.
server-network-by-folder = settings.toml allows the network to all programs in { $folder }.
server-network-in-use = A program that may use the network is running. Stop it first.
server-network-ask-again = This page can't change which programs may use the network. Open the dialog again.

## Problems in a program

# $count is the number of problems that are not listed.
server-more-problems = { $count ->
    [one] There is one more problem. It is listed once you have corrected some of these.
   *[other] There are { $count } more problems. They are listed once you have corrected some of these.
}

## For contributors: learnblock dev

server-dev-no-watchfiles = learnblock dev needs an add-on that is not installed. Install it with: { $command }
server-dev-no-checkout = learnblock dev needs the sources of LearnBlock, including the frontend folder. To use the page, run learnblock.
server-dev-no-node = learnblock dev needs Node.js { $version } or newer.
server-dev-started = The page with hot reload: { $address }

## Lessons

# $problem is a sentence.
server-lesson-file = The lesson '{ $name }' can't be read. { $problem }
server-lesson-name = A lesson can't be called '{ $name }'. Rename the file, with letters, digits and hyphens.
# $problem is a sentence.
server-lesson-missing = The lesson '{ $name }' of this project can't be opened. { $problem }
server-lesson-none = This project has no lesson.
server-lesson-no-checks = There is nothing to hand in in this step. Go to a step with a program to write.
server-lesson-other-robot = This step is not meant for the robot '{ $robot }'.
server-lesson-no-hint = There are no more hints for this run. Change the program and run it again.
server-lesson-no-question = This step has no such question.
server-lesson-checking = The program is being checked already. Wait, or stop the check.
server-lesson-not-met = A goal was not reached.
server-lesson-too-many = You already have { $limit } lessons of your own. Delete one first.
server-lesson-only-here = Only someone at the computer that runs LearnBlock can add, change or delete lessons, or see their solutions.
