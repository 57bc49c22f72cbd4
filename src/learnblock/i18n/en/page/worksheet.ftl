# A lesson on paper.

page-worksheet-name = Name:
page-worksheet-step = { $number }. { $title }
page-worksheet-goals = Goals:
page-worksheet-cut = Cut out these blocks and put them in order. Blocks that go inside another one go into its gap.
page-worksheet-write = Write your program, one block on each line:
page-worksheet-notes = Write what you see and think:
page-worksheet-solutions = Solutions: { $title }
page-worksheet-answer = Answer:
