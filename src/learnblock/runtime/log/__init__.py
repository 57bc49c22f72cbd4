"""The log of a run: what the program decided, remembered and called, and why.

The program that is run is an instrumented copy of the user's (`instrumenting`); what it does is
noted in its own process (`noting`) as `events`, sent to the host in batches, and kept there
(`keeping`), beside what happened in the world. `files` stores and reads it.

The trace is apart from it: a run has the same trace with a log and without.
"""
