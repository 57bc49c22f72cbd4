# Names that do not exist: of robots, worlds, skills, settings and so on.
# $kind is a short name of what was looked for; $name is the unknown name.

unknown-name =
    There is { $kind ->
        [behaviour] no behaviour
        [block] no custom block
        [block-set] no block set
        [button] no button
        [camera] no camera
        [check] no check
        [colour] no colour
        [component] no component
        [connection] no connection
        [deleted-block] no deleted block
        [detector] no detector
        [device] no device
        [device-function] no device function
        [direction] no direction
        [emotion] no emotion
        [emulator] no emulator
        [event] no event
        [example] no example
        [function] no function
        [goal] no goal
        [hint] no hint
        [joint] no joint
        [key] no key
        [led] no LED
        [lesson] no lesson
        [lesson-aim] no aim
        [lesson-step] no step
        [library] no library
        [door] no door
        [light-object] no object with a mass
        [line] no line
        [note] no note
        [project] no project
        [robot] no robot
        [setting] no setting
        [simulated-robot] no simulated robot
        [skill] no skill
        [start-pose] no start pose
        [tag] no tag
        [team] no team
        [thing] no object
        [variable] no variable
        [version] no version
        [world] no world
       *[other] no
    } '{ $name }'.
# $known lists the names that exist.
unknown-name-of =
    { unknown-name } Known names: { $known }.
# $suggestion is the most similar name that exists.
unknown-name-like =
    { unknown-name } Did you mean '{ $suggestion }'?
