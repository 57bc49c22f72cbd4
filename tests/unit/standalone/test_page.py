"""A page in one file holds its content, and asks no network for anything."""

import base64
import gzip
import json
import re

from learnblock.standalone.page import filled


def test_the_content_comes_out_as_it_went_in():
    content = {"text": "</script>{code}¡Hola!"}
    packed = re.search(r'id="content">([^<]*)<', filled(content))
    assert packed
    assert json.loads(gzip.decompress(base64.b64decode(packed[1]))) == content


def test_the_page_allows_no_network():
    page = filled({})
    assert "default-src 'none'" in page
    assert not re.search(r'(?:src|href)="', page)
