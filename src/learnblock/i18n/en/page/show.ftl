# Showing a program to a classmate, on pupils' pages.

page-show-title = Show a classmate
page-show-how = Your classmate can open a copy. Yours stays as it is.
page-show-none-here = None of your classmates is here at the moment.
# $name is a classmate, $project the name of a project.
page-show-offer = { $name } shows you “{ $project }”.
page-show-open = Open
page-show-not-now = Not now
