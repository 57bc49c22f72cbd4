"""A class in one room: pupils join by a word, each with a LearnBlock of their own.

One process, the classroom, listens on the network. It knows the pupils (`roster`), lets them in
(`entrance`), and passes each message between a page and that pupil's own server on (`relay`), if
the table `rights` allows it. To keep pupils out of each other's work, each pupil has a
process, a folder and settings of their own (`pupil_server`).
"""
