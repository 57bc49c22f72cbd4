# Worlds as files: the menu in the head of the world.

page-worlds-import = Import world…
page-worlds-export = Download world
page-worlds-variant-choose = Choose a variant…
page-worlds-variant = Variant { $number }
page-worlds-variant-title = Variant of the world
page-worlds-variant-number = Number
page-worlds-variant-help = 0 is the world as it is drawn. In every other variant the start, objects, light and noise differ a little; variant 7 is the same on every computer. A good program reaches its goal in all of them.
page-worlds-variant-any = Any
page-worlds-variant-show = Show
page-worlds-rename = Rename…
page-worlds-delete = Delete
page-worlds-rename-title = Rename world
page-worlds-rename-help = Projects and the command line still know this world as { $name }.
page-worlds-rename-now = Rename
page-worlds-deleted = { $title } is in the trash.
page-worlds-restore = Restore
page-worlds-large-file = { $name } is too large. Copy its .toml file and its picture into the folder 'worlds' of your own folder.
