"""The built-in skills: functions whose first argument is any robot.

`learnblock.client.skills` finds them.
"""
