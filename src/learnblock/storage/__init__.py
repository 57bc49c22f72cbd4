"""The user's folder and the files in it: read with limits, written completely or not at all."""
