"""Real kernels of notebooks in tests."""

from contextlib import contextmanager

from jupyter_client.manager import start_new_kernel

#: The longest wait in seconds for a busy machine.
_LONG = 100


class Kernel:
    """A kernel that runs cells."""

    def __init__(self, manager, client):
        self.manager, self._client = manager, client

    def begin(self, code):
        """Begin a cell; return what `end` waits for."""
        return self._client.execute(code)

    def end(self, cell):
        """Wait until a cell has ended; return its answer: `ok`, or the name of its error."""
        while True:
            reply = self._client.get_shell_msg(timeout=_LONG)
            if reply["parent_header"].get("msg_id") == cell:
                content = reply["content"]
                return content.get("ename", content["status"])

    def run(self, code):
        """Run a cell; return its answer."""
        return self.end(self.begin(code))

    def outputs(self, code):
        """Run a cell; return its texts, and the bundles that it shows."""
        texts, bundles = [], []

        def take(message):
            content = message["content"]
            if message["msg_type"] == "stream":
                texts.append(content["text"])
            elif "data" in content:
                bundles.append(content["data"])

        self._client.execute_interactive(code, timeout=_LONG, output_hook=take)
        return "".join(texts), bundles


@contextmanager
def kernel():
    """Start a kernel with the environment of this process."""
    manager, client = start_new_kernel(kernel_name="python3", startup_timeout=_LONG)
    try:
        yield Kernel(manager, client)
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
