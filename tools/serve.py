"""Serves a folder of static files on this machine, and opens it in a browser.

python3 tools/serve.py studio/dist --port 8017 [--no-browser]
"""

from __future__ import annotations

import argparse
import errno
import functools
import http.server
import os
import sys
import threading
import webbrowser
from pathlib import Path


class StudioFiles(http.server.SimpleHTTPRequestHandler):
    """Files with the types a browser insists on, never kept stale, without a log line each."""

    extensions_map = {  # noqa: RUF012 (the base class declares it so)
        **http.server.SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".wasm": "application/wasm",
        ".pfs": "text/plain; charset=utf-8",
    }

    def end_headers(self) -> None:
        """Adds the header that makes a rebuilt studio appear at the next reload."""
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing: the page shows what it loads."""


def can_show_a_browser() -> bool:
    """Tells whether a browser opened from here would be seen by someone."""
    if sys.platform.startswith("linux"):
        return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    return True


def main() -> int:
    """Serves until interrupted; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--port", type=int, default=8017)
    parser.add_argument("--no-browser", action="store_true")
    options = parser.parse_args()

    handler = functools.partial(StudioFiles, directory=str(options.folder))
    try:
        server = http.server.ThreadingHTTPServer(("127.0.0.1", options.port), handler)
    except OSError as error:
        if error.errno != errno.EADDRINUSE:
            raise
        print(f"Port {options.port} is taken. Choose another: make run PORT=8018", file=sys.stderr)
        return 1

    address = f"http://localhost:{server.server_address[1]}"
    print(f"pforms studio: {address}   (Ctrl-C ends it)", flush=True)
    if not options.no_browser and can_show_a_browser():
        threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
