# The robot's camera and display.

page-camera-camera = Robot camera
page-camera-picture = Camera picture. Everything recognised in it is listed below.
page-camera-found = Recognised in the picture
page-camera-no-camera = This robot has no camera.
page-camera-not-kept = The picture of this moment was not recorded.
page-camera-tag = Tag
page-camera-face = Face
page-camera-feeling-face = Face: { $emotion }
page-camera-line = Line
page-camera-object = { $colour ->
    [red] Red thing
    [orange] Orange thing
    [yellow] Yellow thing
    [green] Green thing
    [blue] Blue thing
   *[purple] Purple thing
}
page-camera-lamps = Lights
page-camera-off = off
page-camera-fear = afraid
page-camera-surprise = surprised
page-camera-anger = angry
page-camera-sadness = sad
page-camera-disgust = disgusted
page-camera-joy = happy
page-camera-neutral = calm
page-camera-black = black
page-camera-red = red
page-camera-blue = blue
page-camera-left = left
page-camera-center = middle
page-camera-right = right
