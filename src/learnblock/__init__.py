"""LearnBlock: one program in blocks, Block-Text and Python, for any robot."""
