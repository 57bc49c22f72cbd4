# What called what in a run.

page-calls-title = What called what on { $robot }
page-calls-none = Run the program to see what it calls.
page-calls-count = { $count }× · { NUMBER($seconds, maximumFractionDigits: 1) } s
page-calls-function = { $name }, { $layer }: called { $count ->
    [one] once
   *[other] { $count } times
} by { $callers }, { NUMBER($seconds, maximumFractionDigits: 2) } s
page-calls-share = { $percent } %
page-calls-span = Span of time
page-calls-from = From (s)
page-calls-to = To (s)
page-calls-from-here = From this moment
page-calls-to-here = To this moment
page-calls-whole = Whole run
page-calls-beside = Calls side by side
