# Libraries of skills: their files, their names, and installing them.

library-not-found = There is no library here. Give a file that ends in { $ending }, or a folder with a { $manifest }.
library-not-downloaded = LearnBlock does not download libraries. Download it yourself, look at it, and import the file.
# $limit is a number of bytes.
library-file-too-large = The file is too large: the limit is { $limit } bytes.
library-too-large = The library is too large: the limit is { $limit } bytes.
library-too-many-files = A library can have at most { $most } files.
library-limits = A library can have at most { $most } files with { $limit } bytes in total.
library-not-plain-file = { $file } is not a plain file. Remove it from the library.
library-not-zip = This file is damaged or not a library.
library-file-outside = The file '{ $file }' would be outside the library.
# $known lists names of files.
library-unknown-file = A library can only have the files { $known }, and Python files with lower-case names.
library-not-utf-8 = This file is not UTF-8. Save it as UTF-8.
library-no-manifest = This is not a library: it has no { $manifest }.

library-two-skills = The skill '{ $skill }' is also in { $file }. Keep one of them.
library-no-skill = This library has no skill. Write a function whose first parameter is 'robot'.
library-other-statement = A library can only have functions and the variables that they share.
library-python-name = '{ $name }' cannot be the name of a skill, because Python uses it. Rename it.
library-functions-in-package = When a library has several files, LearnBlock generates { $file }. Move its functions to another file.
library-first-parameter = In a library, the first parameter of '{ $function }' must be 'robot'.
library-foreign-skill = '{ $function }' uses function.{ $skill }, which is not in the library. Add that block to the library.
library-bad-name = A library cannot be named '{ $name }'. Choose another name.

# Renaming of skills.
library-unusual-name = '{ $name }' is spelled in an unusual way here. Rename it by hand.
library-name-used = '{ $name }' is already used here. Choose another name.
library-two-meanings = '{ $name }' also has another meaning here. Rename it by hand.
library-skill-exists = The library already has a skill '{ $skill }'. Choose another name.
library-bad-skill-name = '{ $name }' cannot be the name of a skill. Use letters, digits and _.

# Names that are taken. $place is one of the places below.
library-clash = The skill '{ $skill }' of the library { $library } already exists in { $place }. Rename it with --rename { $skill }=NEW.
library-place-library = the library { $library }
library-place-block = your custom block { $block }
library-place-plugin = a plugin
library-place-learnblock = LearnBlock
library-place-robot = every robot

library-two-names = library.toml has the name { $name }, but the folder is named { $folder }.
library-same-name = Two of these libraries have the same name. Import only one of them.
library-not-newer = Version { $installed } of the library { $library } is installed, and { $version } is not newer. Add --replace to install it anyway.
# One file of a library cannot be read. $problem begins with the line.
library-broken-file = { $file }: { $problem }
