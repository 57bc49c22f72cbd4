# The gallery of worlds.


page-gallery-open = All worlds…
page-gallery-title = Choose a world
page-gallery-search = Search worlds
page-gallery-groups = What to do there
page-gallery-all = All
page-gallery-all-of = All { $count }
page-gallery-all-worlds = All { $count } worlds
page-gallery-count = { $count ->
    [one] One world
   *[other] { $count } worlds
}
page-gallery-none = No world called “{ $words }” yet.
page-gallery-used = In use
page-gallery-make = Make a world
page-gallery-make-help = Drag things in, then play
page-gallery-more = More about { $title }
page-gallery-needs = Needs { $what }: { $robots }
page-gallery-robots = { $count } robots
page-gallery-all-robots = all robots
page-gallery-easy = Easy
page-gallery-medium = Medium
page-gallery-tricky = Tricky
page-gallery-group-games = Games
page-gallery-group-drive = Drive
page-gallery-group-obstacles = Obstacles
page-gallery-group-lines = Lines
page-gallery-group-tags = Camera and tags
page-gallery-group-faces = Faces and feelings
page-gallery-group-several = Several robots
page-gallery-group-empty = Empty
