"""The server of the page: sessions, projects, and the conversation with browsers."""
