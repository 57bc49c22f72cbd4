# Projects: their files, names and folder, and what a page does with an open project.

## Names and files

project-name-wrong = A project can't be called '{ $name }'. Use up to { $limit } letters, digits, spaces, '-', '_' and '.', and start with a letter or a digit.
project-name-device = Windows reserves the name '{ $name }' for a device. Choose another name.
# $code is the character's number, such as D800.
project-character = The character U+{ $code } can't be saved. Remove it from the program.
project-program-too-long = The program has { $size } characters, more than the { $limit } that LearnBlock can edit. Split it into several programs or functions of a library.
project-too-large = The project has { $size } bytes, but a project can have at most { $limit }.
# $names is a list of names.
project-code = { $file } brings code that is not installed here: { $names }. To read and install it, run: { $command }
project-type = LearnBlock can't open this type of file. Choose a .bt, .py, .learnblock or .blockProject file.
# $start is how the file of a project starts.
project-none = This file is damaged or not a LearnBlock project. A project file starts with { $start }.
project-not-utf-8 = This file is damaged or not a LearnBlock project: byte { $byte } is not UTF-8.
# $reason is a technical text in English.
project-damaged = This file is damaged or not a LearnBlock project: { $reason }. Use an older copy of the file.
project-too-deep = The brackets in this file are nested too deeply for a project.
project-version = This project uses version { $version } of the format, but this LearnBlock reads version { $known }. Open it with a newer LearnBlock.
# $kind is robot or world; $value is what the file says.
project-path = { $kind ->
        [robot] The robot is { $value }, but a project can only name a robot, such as '{ $example }'.
       *[world] The world is { $value }, but a project can only name a world, such as '{ $example }'.
    }
# $place is where in the file; $expected is one of the sentences below.
project-value = { $place } is { $value }. { $expected }
project-value-wrong = { $place } is not valid. { $expected }
project-expects-blocktext = It must be a list of the program's lines.
project-expects-python = It must be a list of the Python program's lines.
project-expects-robot = It must be the name of a robot, such as 'sim-ebo'.
project-expects-world = It must be the name of a world, such as 'line'.
project-expects-breakpoints = It must be a list of at most { $limit } block ids.
project-expects-shown = It must be the name of a block set, such as 'first-steps'.
project-expects-block-sets = It must be a list of at most { $limit } block sets.
# $example is JSON.
project-expects-libraries = It must give the version of each library, such as { $example }.
project-expects-workspace = Remove the workspace from the file to lay the blocks out again.
project-expects-first = It must be the name of the first robot.
project-expects-count = It must be the number of robots that run the program: 1 to { $limit }.
project-expects-others = It must be a list of at most { $limit } robots, each with its name, robot and blocktext.
project-robot-name = The robots of a project need different names of at most 40 letters, digits, spaces and hyphens, unlike '{ $name }'.

## Folder

# $reason is the system's text.
project-no-access = { $action ->
        [read] The project can't be read from { $folder }: { $reason }
        [save] The project can't be saved in { $folder }: { $reason }
        [rename] Can't rename the project in { $folder }: { $reason }
        [delete] The project can't be deleted from { $folder }: { $reason }
        [keep-version] The version can't be saved in { $folder }: { $reason }
        [read-version] The version can't be read from { $folder }: { $reason }
        [keep-run] The run can't be saved in { $folder }: { $reason }
       *[read-runs] The list of runs can't be read from { $folder }: { $reason }
    }
project-name-taken = There is already a project named '{ $name }'. Choose another name.
project-picture-wrong = A picture of a project must be a JPEG of at most { $limit } bytes and { $side } pixels a side.
project-in-use = The project '{ $name }' is open. Close its pages first.

## Opening

# $problem is a sentence.
project-robot-replaced = { $problem } The project now uses the robot '{ $robot }'.
project-world-replaced = { $problem } The project now uses the world '{ $world }'.
project-blocks-replaced = { $problem } The project now shows all blocks.
project-library-missing = This program was made with version { $version } of the library '{ $library }', which is not installed. Import the library.
project-library-older = This program was made with version { $version } of the library '{ $library }', but version { $installed } is installed. Import the newer version.

## What a file carries

# $example is JSON; $last is the highest number of a tag.
project-expects-tags = It must give the number of each tag, from 0 to { $last }, such as { $example }.
project-expects-carried = Remove 'carried' from the file to open the program alone.
project-world-added = This project brought its world '{ $world }'. It is now one of your worlds.
project-world-renamed = You already have another world '{ $world }', so the one of this project is now called '{ $here }'.
# $problem is a sentence.
project-world-damaged = The world '{ $world }' in this project's file can't be used: { $problem }
# $names is a list of names.
project-tags-added = This project brought tag names: { $names }. They are now among your tag names.
project-tag-differs = In this project, the tag '{ $name }' has the number { $number }; in your tag names it has { $here }. The project uses { $number }. To change that, edit your tag names.
# $limit is in bytes.
project-carries-less = The downloaded file lacks the project's world, or its blocks and libraries, because it would be larger than { $limit } bytes. Export them separately.
