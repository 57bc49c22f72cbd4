# The search of the palette: what Scratch, MakeCode and others call things. Each line has words to search for, in lower
# case and with commas between them; a line that ends with -say tells what there is here instead, if no block does just
# that.

# $words: what was searched for
page-search-nearest = No block has the words “{ $words }”. The closest ones:
# The name of a variable for points.
page-search-variable = score

page-search-score = score, points, lives, highscore, counter
page-search-score-say = These blocks count in a game, and a variable counts anything else:
page-search-game = game, game over, win, lose, player, level, sprite, enemy
page-search-game-say = To make a game, drive a robot with keys and count points:
page-search-clone = clone, costume, backdrop, stage, background, character, actor
page-search-clone-say = Here the actor is the robot, and the World menu has the stages. The robot can change its face:
page-search-hide = hide, invisible, disappear
page-search-hide-say = A robot can't hide, but it can show nothing:
page-search-say = say, think, speech, bubble, tell, talk
page-search-smile = smile, laugh, glad, cheerful, joy
page-search-glide = glide, slide, move to, steps, move, walk, run to
page-search-direction = point in direction, point towards, direction, heading, compass, face towards
page-search-position = position, coordinates, coordinate, location
page-search-edge = edge, bounce, bump, collide, collision, touching, touch, hit, crash, overlap
page-search-broadcast = broadcast, message, radio, signal, receive
page-search-flag = green flag, flag, on start, on click, begin, main
page-search-event = event, events, hat, when, whenever, on button pressed, on shake, clicked
page-search-key = key, keys, keyboard, arrow, arrows, joystick, gamepad, button, mouse, cursor
page-search-timer = timer, clock, countdown, stopwatch, running time
page-search-ask = ask, answer, input, question, prompt
page-search-text = join, concatenate, letter, string, contains
page-search-remainder = mod, modulo, remainder, rest of division
page-search-array = array, collection, set of
page-search-function = function, procedure, define, method, subroutine, make a block
page-search-pen = draw, paint, stamp, turtle, pencil, brush
page-search-icon = icon, leds, pixel, plot, heart, show icon
page-search-volume = volume, loud, quiet, mute
page-search-microphone = microphone, loudness, hear, clap, sound level
page-search-microphone-say = These robots have no microphone. They can react to being shaken or bumped:
page-search-temperature = temperature, magnet, magnetic, humidity, acceleration
page-search-temperature-say = These robots don't measure that. They do measure light and tilt:
page-search-servo = servo, arm, gripper, lift, claw
page-search-leave = break, exit, end, stop all, escape, continue
page-search-animate = animate, animation, dance, act
page-search-dictionary = map, object, record, json
page-search-size = size, grow, shrink, bigger, effect, layer
page-search-size-say = A robot keeps its size. Its lights and its face can change:
