# Grading: learnblock grade, and its page.

grade-running = Grading
grade-stopped = Stopped. The results so far are written; the same command again makes what is missing.
grade-written = Results: { $file }
grade-not-made = { $count ->
        [one] { $count } run
       *[other] { $count } runs
    } could not be made: { $reason } The same command makes what is missing.
grade-files-or-class = Name the files or folders to grade, or a class with --class NAME.
grade-jobs-or-scheduler = Use either --jobs or --scheduler.
grade-nothing-handed-in = There is no program (.bt, .py or .learnblock) in what was handed in.
grade-no-checks = No step of { $lesson } has checks.
grade-real-robot = { $robot } is a real robot. Grading needs simulated robots, such as sim-ebo.
grade-many-programs = There are more than { $most } programs in the folder: { $files } ... Leave only those to grade.
grade-no-program = There is no program (.bt, .py or .learnblock) in the folder.
grade-not-begun = Has not begun this step.
grade-not-handed-in = Has not handed this step in yet.
grade-left-out = { $file } has files that can't be unpacked: { $names }{ $more ->
    [0] .
   *[other] { " " }and { $more } more.
} They are left out; the others are graded.
grade-zip-damaged = { $file } is damaged or encrypted, or not a zip. Download it again, or unzip it and grade the folder.
grade-zip-too-large = { $file } has too much in it for one class. Unzip it, and grade a part of it at a time.
grade-folder-in-use = Another grading is using { $folder }. Wait for its end, or choose another folder.
grade-other-version = This computer has LearnBlock { $here }, but the grading was started with { $there }. Install the same version on all.
grade-no-dask = Clusters need an add-on that is not installed. Install it with: { $command }
grade-no-scheduler = No Dask scheduler answers at { $address }. Is it running, and is the address right?
grade-no-workers = The Dask scheduler at { $address } has no workers. Start at least one: dask worker { $address }
grade-workers-lost = The workers were lost again and again. What is finished is kept; the same command again makes what is missing.
grade-trace-too-long = The program did so much that its record is longer than { $limit } MB. It is not judged.

grade-page-title = { $lesson }, step { $step }
grade-page-programs = Programs
grade-page-tried = { $tries ->
    [one] tried once
   *[other] each tried { $tries } times
}
grade-page-of = of { $count }
grade-page-without = No program
grade-page-most-missed = Missed most often
grade-page-to-look-at = To look at
grade-page-no-mark = No mark is final: you decide. These results come from fixed rules that only count what a robot did in a simulator and how a program is built. They don't know what a pupil has understood, tried or been told. No artificial intelligence is involved.
grade-page-overview = Overview
grade-page-pupil = Pupil
grade-page-pupils = Every program
grade-page-done = Step done
grade-page-done-in = step done in { $done } of { $tries }
grade-page-first-hint = First hint
grade-page-clusters = Like mistakes
grade-page-no-clusters = No two programs miss the same checks with the same hint.
grade-page-cluster = { $count } programs miss:
grade-page-alike = Programs that are alike
grade-page-alike-note = Programs are compared without comments and layout. "Same" is the same program; "same except for names" has other names for variables and functions; "alike" shares at least 80 % of its parts of six words each, without those of the program that everyone started with. Short programs for one task are alike by themselves, and pupils may have worked together: this says nothing about who wrote what.
grade-page-none-alike = No two programs are alike.
grade-page-more-alike = { $count } more pairs are alike.
grade-page-kind-same = same
grade-page-kind-renamed = same except for names
grade-page-kind-alike = { $share } % alike
grade-page-hints = Hints that fit
grade-page-differs = A run of this program in one process with its robot differed from an isolated run. All its runs were made again in isolation, and those count.
grade-page-not-made = A run could not be made: { $error }
grade-page-again = To repeat it:
grade-page-program = Program
grade-page-attempt = { $robot }, variant { $variant }, seed { $seed }
grade-page-robot = Robot
grade-page-variant = Variant
grade-page-seed = Seed
grade-page-ended = Ended
grade-page-seconds = Seconds
grade-page-checked = How checked
grade-page-trace = Trace (SHA-256)
grade-page-not-finished = not finished
grade-page-not-run = could not be run
