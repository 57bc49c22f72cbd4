# What cameras see: detectors, tag names, webcams, videos and components.

# Why emotions are not recognised on real cameras: shown by "learnblock perception".
perception-emotions-off =
    Emotion recognition on real cameras, webcams and videos is off. In the European Union, Article
    5(1)(f) of the AI Act (Regulation (EU) 2024/1689) forbids systems that infer the emotions of
    people in education and at work, except for medical and safety reasons. Other laws and the rules
    of your school may forbid it too. Drawn and simulated faces are not people, so recognition
    always works on them.

    Only an adult who uses it where the law allows it should turn it on. Pictures are never stored,
    and are sent only to components that you configure yourself.
# $why is the text above.
perception-component-not-allowed =
    The component { $component } was not started because it might see the faces of real people.

    { $why }

    If it will only see drawn and simulated faces, start it with --only-drawn-faces. To turn emotion recognition on, run: learnblock perception set emotions_on_cameras true
# $address is HOST:PORT; $reason is a message of the operating system.
perception-component-cannot-listen = The component { $component } cannot listen at { $address } ({ $reason }). Choose another --port or --host.
# $component is apriltag or emotionrecognition; $reason is what went wrong.
perception-component-unreachable = The component { $component } at { $address } cannot be reached: { $reason } Start it, or use LearnBlock's own detector: learnblock perception set { $component } --default
perception-component-refused = The component { $component } at { $address } refused the request: { $reason } To use LearnBlock's own detector instead, run: learnblock perception set { $component } --default

# Webcams and videos. $webcam is the number of the webcam.

perception-webcam-silent = Webcam { $webcam } has not sent a picture. Check that it is plugged in and not used by another program, or turn it off: learnblock perception set webcam --default
perception-webcam-closed = Webcam { $webcam } cannot be opened. Check that it is plugged in and not used by another program, or turn it off: learnblock perception set webcam --default
perception-webcam-without-pictures = Webcam { $webcam } sends no pictures. Check that it is plugged in and not used by another program, or turn it off: learnblock perception set webcam --default
perception-webcam-lost = Webcam { $webcam } stopped sending pictures. Check that it is still plugged in, or turn it off: learnblock perception set webcam --default
perception-video-missing = There is no video { $path }. Choose another one, or turn it off: learnblock perception set video --default
perception-video-unreadable = The video { $path } contains no pictures that can be read. Choose another one, or turn it off: learnblock perception set video --default

# Pictures given to a detector. $shape is the shape of a numpy array.

perception-frame-not-array = A picture must be a numpy array of uint8 with the shape (height, width, 3), not a { $type }.
perception-frame-not-uint8 = The values of a picture must be uint8, not { $type }.
perception-frame-wrong-shape = A picture must have the shape (height, width, 3), not { $shape }.
perception-frame-empty = The picture is empty: its shape is { $shape }.
perception-frame-too-large = The picture with the shape { $shape } is too large. Each side can be at most { $limit } pixels.
# $name is focal or size.
perception-tag-size = '{ $name }' is { $value }, but it must be greater than 0.
perception-no-weights = The weights of the emotion detector ({ $path }) are missing. Build them with: { $command }
# Pictures sent to a component. $depth is a number of bytes for each pixel.
perception-picture-not-rgb = The image sent ({ $width } × { $height } pixels) has { $depth } bytes per pixel. Send an RGB image, with 3 bytes per pixel.
perception-picture-too-large = A picture of { $width } by { $height } pixels is too large. At most 1920 by 1200 pixels are allowed.
perception-picture-wrong-size = A picture of { $width } by { $height } pixels has { $expected } bytes, but { $size } were sent.

# The names of tags, in tags.toml.

perception-tags-too-large = The file is too large for tag names: it has { $size } characters, and the limit is { $limit }.
perception-tags-too-many = The file has { $count } tag names. At most { $limit } are allowed.
perception-tags-not-toml = Tag names are lines such as: ball = 3 ({ $reason })
perception-tags-bad-name = '{ $name }' cannot be the name of a tag. Use 1 to { $limit } printable characters.
perception-tags-number-as-name = '{ $name }' is a number, so it cannot be the name of a tag. Use at least one letter.
perception-tags-bad-number = '{ $name }' has the value { $value }. The number of a tag is a whole number from 0 to { $last }.

# The settings of camera recognition.
perception-setting-component = HOST:PORT of a component to use; empty for LearnBlock's own detector
perception-setting-emotions = recognise emotions on real cameras; the law may forbid it
perception-setting-layout = meaning of a picture's width for components: rows (RoboComp's), columns or auto
perception-setting-video = a video file to use in place of the webcam; empty for none
perception-setting-webcam = this computer's webcam to use as an extra camera: 0 is the first one
