# Versions and runs of a project.

page-history-title = History
page-history-versions = Versions
page-history-runs = Runs
page-history-no-versions = No versions yet. LearnBlock saves one with every run.
page-history-no-runs = The program has not been run yet.
page-history-restore = Restore
page-history-restore-of = Restore the version from { $date }
page-history-lines = { $lines ->
    [one] 1 line
   *[other] { $lines } lines
    }
page-history-reason-run = Before a run
page-history-reason-time = Saved automatically
page-history-reason-restored = Before restoring
page-history-reason-outside = Changed by another program
page-history-reason-conflict = The other change of the same line
