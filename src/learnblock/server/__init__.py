"""The server of the page: sessions, projects, and the messages to and from browsers."""
