# Custom blocks: their names, their source and their configuration.

custom-bad-name = A block cannot be named '{ $name }'. Use at most { $most } letters, digits, spaces, - and _, and begin with a letter or digit.
custom-device-name = Windows uses the name '{ $name }' for a device. Choose another name.
custom-name-taken = You already have a block '{ $name }'. Choose another name, or replace that block.
# $reason is the operating system's, or another message.
custom-unreadable = The file cannot be read: { $reason }

# Files of exported blocks. $limit is a number of characters.
custom-file-too-large = The file is too large: the limit is { $limit } characters.
custom-not-exported = This is not a block exported from LearnBlock: { $reason }
custom-file-version = This block has format { $version }, but this LearnBlock reads format { $known }. Update LearnBlock.

# The source. $reason is Python's.
custom-source-too-large = The source is too long: the limit is { $limit } characters.
custom-not-python = This is not valid Python: { $reason }
custom-no-function = No function takes the robot as its first parameter. Write one, such as 'def dance(robot, times: int = 3):'.
custom-async = '{ $name }' is async, which a block cannot be. Write 'def { $name }'.
custom-no-robot = '{ $name }' is not a block, because it does not take the robot. Make 'robot' its first parameter, or name a helper '_{ $name }'.
custom-first-parameter = The first parameter of '{ $name }' receives the robot, so name it 'robot' instead of '{ $parameter }'. Other parameters follow it.
custom-duplicate-function = '{ $name }' is also defined on line { $line }, and only this one is used. Rename one of them.
custom-unfit-parameter = A block cannot set the parameter '{ $parameter }' of '{ $name }'. Remove the *, or give it a default.
custom-python-word = '{ $name }' means '{ $plain }' in Block-Text. Choose another name.
# $problem is a whole sentence.
custom-bad-hint = Type hint of '{ $parameter }' in '{ $function }': { $problem }
# $expected is a whole sentence.
custom-bad-default = The default { $default } does not fit '{ $parameter }' of '{ $function }'. { $expected }

# Names that others have.
custom-taken-by-block = Your block '{ $block }' already has a function '{ $name }'. Choose another name.
custom-taken-by-library = The library '{ $library }' already has a skill '{ $name }'. Choose another name.
custom-taken-by-plugin = A plugin already has a skill '{ $name }'. Choose another name.
custom-taken-by-robot = Every robot already has a '{ $name }'. Choose another name.
custom-taken-by-skill = LearnBlock already has a skill '{ $name }'. Choose another name.

# Configurations that no longer fit the source.
custom-stale-function = The configuration describes '{ $name }', but there is no such function. This part is ignored.
custom-stale-parameter = '{ $block }' has no parameter '{ $parameter }'. This part of the configuration is ignored.
custom-stale-type = '{ $parameter }' of '{ $block }' is { $actual } in the function but { $chosen } in the configuration. The function takes precedence.
custom-stale-shape = '{ $block }' is { $kind ->
    [value] a value
   *[statement] a statement
} in the function but not in the configuration. The function takes precedence.

# Imports in the source.
custom-import-relative = An import cannot begin with a dot here, because each file of blocks is separate. Import packages by name.
custom-import-package = import { $module }: the package '{ $package }' is not installed. Check the name, or install the package where LearnBlock is installed.
custom-import-library = import { $module }: the library '{ $library }' is not installed. Import its file first.
custom-import-module = import { $module }: LearnBlock has no such module.
custom-import-module-like = import { $module }: LearnBlock has no such module. Did you mean '{ $suggestion }'?
custom-import-name = { $module } has no '{ $name }'.
custom-import-name-like = { $module } has no '{ $name }'. Did you mean '{ $suggestion }'?
