# Pictures and films of the world.

page-share-picture = Save picture
page-share-film = Film a run
page-share-filming = Filming
page-share-saved = Film saved.
page-share-no-film = This browser can't make films. Save a picture instead, or use a newer browser.
