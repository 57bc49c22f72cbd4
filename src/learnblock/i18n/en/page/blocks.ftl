# The view of the program as blocks.

page-blocks-label = Program as blocks
page-blocks-search = Search
page-blocks-search-blocks = Search for blocks
page-blocks-search-program = Search in the program
page-blocks-previous = Previous
page-blocks-next = Next
page-blocks-close = Close
page-blocks-loading = Loading blocks… You can edit the text in the meantime.
page-blocks-failed = The blocks could not be loaded. Check that LearnBlock is running, then reload the page.
page-blocks-new-when = New event…
page-blocks-when-name = event
page-blocks-when-prompt = Name of the new event:
page-blocks-breakpoint = Breakpoint: the program pauses before this block
page-blocks-add-breakpoint = Add breakpoint
page-blocks-remove-breakpoint = Remove breakpoint
page-blocks-show-in-texts = Show in code
page-blocks-search-hint = Type to search for blocks
page-blocks-search-nothing = No matching blocks
page-blocks-search-found = { $count ->
    [one] 1 matching block
   *[other] { $count } matching blocks
    }
page-blocks-slider = slider
page-blocks-angle = angle in degrees, clockwise
page-blocks-colour = colour
page-blocks-other-colour = custom colour
page-blocks-tag = tag number or name
page-blocks-colour-red = red
page-blocks-colour-orange = orange
page-blocks-colour-yellow = yellow
page-blocks-colour-green = green
page-blocks-colour-cyan = cyan
page-blocks-colour-blue = blue
page-blocks-colour-purple = purple
page-blocks-colour-pink = pink
page-blocks-colour-white = white
page-blocks-colour-black = black
page-blocks-own = My blocks
page-blocks-new-own = New block…
page-blocks-all-own = Manage my blocks…
page-blocks-edit-own = Edit this block's code…
page-blocks-call = function call
page-blocks-call-value = function result
