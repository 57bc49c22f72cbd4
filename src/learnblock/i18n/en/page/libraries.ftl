# Libraries of skills.

page-libraries-title = Libraries
page-libraries-menu = Libraries…
page-libraries-help = A library adds blocks that other people made. They have their own tab in the palette.
page-libraries-none = No libraries installed yet.
page-libraries-import = Import files…
page-libraries-import-now = Import
page-libraries-more = More files…
page-libraries-make = Create library…
page-libraries-use = Use
page-libraries-use-one = Use { $name } in this program
page-libraries-used = The program now imports { $name }.
page-libraries-download = Download { $name }
page-libraries-remove = Remove { $name }
page-libraries-remove-now = Remove
page-libraries-keep = Keep
page-libraries-really-remove = Remove { $name }? Programs that import it will stop working.
page-libraries-removed = { $name } removed.
page-libraries-imported = Imported: { $names }.
page-libraries-made = { $filename } created.
page-libraries-wrong-file = { $name } is not a library. Choose a .lblib file of at most 1 MB.
# $name is NAME.conf or NAME.py, and $needed is NAME.lb.
page-libraries-part = { $name } is only a part of a library. Choose { $needed } too.
page-libraries-too-many = { $most ->
    [one] You can import 1 library at a time.
   *[other] You can import at most { $most } libraries at a time.
    }
page-libraries-nothing-runs = Nothing in a library runs until one of your programs uses it.
page-libraries-installed = Version { $version } is already installed. It is the same or newer.
page-libraries-replace = Replace { $names }
page-libraries-leave-out = Skip { $name }
page-libraries-clash = The name { $skill } is already used: { $place }.
page-libraries-new-name = New name for { $skill }
page-libraries-make-help = Choose what others can use. Each function includes the functions it calls.
page-libraries-name = Name
page-libraries-name-help = Lowercase letters, digits and _. Programs import the library by this name.
page-libraries-version = Version (higher is newer)
page-libraries-version-help = For example 1.0.0
page-libraries-label = Tab name
page-libraries-label-help = Default: the library's name
page-libraries-functions = Functions in this program
page-libraries-no-functions = This program has no functions.
page-libraries-own = My blocks
page-libraries-along = includes { $names }
page-libraries-make-now = Create and download
