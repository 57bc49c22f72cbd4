# Pictures of programs that the command line draws with a browser.

picture-no-browser = Drawing blocks needs Chrome, Edge or Chromium, and none is installed. Install one, or save the picture on the page: Share, Picture of the program.
picture-browser-failed = { $browser } did not draw the picture. Try again, or save the picture on the page: Share, Picture of the program.
picture-unknown-type = { $file } is not a picture's name. End it in .svg or .png.
picture-unknown-sheet = { $file } is not a worksheet's name. End it in .html or .pdf.
