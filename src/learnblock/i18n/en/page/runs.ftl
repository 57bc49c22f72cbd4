# The kept runs of a project. $name is the name of a run, or its date.

page-runs-none = The program has not been run yet. Its last 20 runs are kept here, and those that you name.
page-runs-open-file = Open a run from a file
page-runs-name-of = Name { $name }
page-runs-delete-of = Delete { $name }
page-runs-name = Name this run
page-runs-name-help = A run with a name is kept until you delete it.
page-runs-name-now = Name
page-runs-download = Download { $name }
page-runs-restore = Use its program again
page-runs-delete = Delete run
page-runs-delete-named = Delete { $name }?
page-runs-delete-help = The run can't be restored.
page-runs-damaged = This file is damaged and can't be opened.
page-runs-cut-off = Cut off
page-runs-foreign = from a file
page-runs-wrong-file = { $name } is not a run. Choose a { $ending } file.
page-runs-large-file = { $name } is too large for a run.
page-runs-not-sent = { $name } could not be opened: LearnBlock does not answer.
page-runs-shown = Run shown: { $name }.
page-runs-changed = The program has changed since: answers name lines of the older program.
page-runs-other-program = It is a run of another program: answers name its lines.
page-runs-newest = Newest run
page-runs-back = Back to the newest run
page-runs-console = The output of the run { $name }

# Two runs compared.
page-runs-choose = Compare { $name }
page-runs-compare = Compare
page-runs-compare-help = Tick two runs to compare them.
page-runs-compare-end = End comparison
page-runs-compared = Comparison
page-runs-legend = Ways of the compared runs
page-runs-same = Both runs made the same decisions.
page-runs-together = Both runs did the same until { $seconds } s.
page-runs-moment-first = That moment in the first run
page-runs-moment-second = and in the second
