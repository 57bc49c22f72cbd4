# Links that hold a project, and what is said about its run.

share-too-large = This program is too large for a link: { $size } characters, and a link has at most { $limit }. Share the file instead.
share-too-long = This link is too long: it can have at most { $limit } characters. Ask for the file instead.
share-no-link = This isn't a LearnBlock link. Copy the whole link, from http to its end.
share-damaged = This link is damaged or cut off. Copy the whole link, from http to its end.
share-version = This link uses version { $version } of the format. Open it with a newer LearnBlock.
share-opened = Opened from a link. Run compares its run with the one that was shared.
share-opened-no-run = Opened from a link.
share-differs-program = The program has changed since it was shared.
share-differs-robot = The robot is another one.
share-differs-world = The world or its variant is another one.
share-differs-place = The robot was placed elsewhere.
share-differs-version = It was shared from LearnBlock { $theirs }; this is { $ours }.
share-differs-stopped = The run was stopped.
share-differs-time = The shared run took { $theirs } seconds, this one { $ours }.
share-differs-else = The answers, keys or settings on this computer are different.
share-no-run = Run the program to its end, and the link proves its run.
share-no-run-changed = The program, its world or its place has changed since the last run. Run it again, and the link proves its run.
share-no-run-real = A real robot never drives exactly the same way twice, so the link has no fingerprint.
share-no-run-person = This run depended on keys, answers or a guest's program, so the link has no fingerprint.
share-no-run-stopped = The last run was stopped. Let the program end by itself, and the link proves its run.
