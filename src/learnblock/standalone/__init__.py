"""Pages in one file, which need neither a server nor a network.

| file | what it does |
|---|---|
| `browser.py` | finds a browser without a window, and reads what a page makes in it |
| `page.py` | fills the page with a picture to draw, or with a run |
| `pictures.py` | pictures of programs |
"""
