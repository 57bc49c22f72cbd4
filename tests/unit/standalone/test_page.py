"""A page in one file holds its content, and asks no network for anything."""

import re

from learnblock.standalone.page import filled
from page_files import content_of


def test_the_content_comes_out_as_it_went_in():
    content = {"text": "</script>{code}¡Hola!"}
    assert content_of(filled(content)) == content


def test_the_page_allows_no_network():
    page = filled({})
    assert "default-src 'none'" in page
    assert not re.search(r'(?:src|href)="', page)
