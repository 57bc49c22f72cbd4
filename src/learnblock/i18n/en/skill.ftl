# Skills that fail, and files of skills that cannot be loaded. $file is such as skills/dance.py.

skill-not-function = In { $file }, '{ $name }' is no longer a function once the file has run. Give the other value a different name.
skill-file-syntax = { $file } can't be loaded because of a mistake on line { $line }: { $reason }.
# $reason is an error of the file in English, such as ZeroDivisionError: division by zero
skill-file-broken = { $file } can't be loaded ({ $reason }). Correct the file and run the program again.
# A turn that takes too long; $turned and $angle in degrees.
skill-still-driving = The robot drove only { $driven } of { $distance } mm in { $seconds } seconds. Is it stuck, or lifted off the floor?
skill-speed-not-positive = The speed is { $value } mm/s. Write a speed of more than 0; a negative distance drives backwards.
skill-radius-not-positive = The radius is { $value } mm. Write a radius of more than 0; a negative angle drives to the left.
skill-turning-speed-not-positive = The turning speed is { $value }°/s. Write a speed of more than 0; a negative angle turns to the left.
skill-still-turning = The robot turned only { $turned } of { $angle } degrees in { $seconds } seconds. Is it stuck, or lifted off the floor?
