"""`learnblock new`: files for what people add to LearnBlock, complete as far as they can be.

A robot from its description, a skill, a world. The texts stand in `learnblock.templates`.
"""
