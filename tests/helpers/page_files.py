"""Pages in one file: their content, and those in the frames of notebooks."""

import base64
import gzip
import html
import json
import re


def content_of(page):
    """What was written into a page."""
    packed = re.search(r'id="content">([^<]*)<', page)
    return json.loads(gzip.decompress(base64.b64decode(packed[1])))


def content_in_frame(frame):
    """What was written into the page in a frame."""
    return content_of(html.unescape(re.search(r'srcdoc="([^"]*)"', frame)[1]))
