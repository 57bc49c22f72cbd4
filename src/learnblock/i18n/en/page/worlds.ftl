# Worlds as files: the menu in the head of the world.

page-worlds-menu = World menu
page-worlds-import = Import world…
page-worlds-export = Download world
page-worlds-rename = Rename…
page-worlds-delete = Delete
page-worlds-rename-title = Rename world
page-worlds-rename-help = Projects and the command line still know this world as { $name }.
page-worlds-rename-now = Rename
page-worlds-deleted = { $title } is in the trash.
page-worlds-restore = Restore
page-worlds-large-file = { $name } is too large. Copy its .toml file and its picture into the folder 'worlds' of your own folder.
