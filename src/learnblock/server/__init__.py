"""The server of the page: sessions, runs, and the messages to and from browsers."""
