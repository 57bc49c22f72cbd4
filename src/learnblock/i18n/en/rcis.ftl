# RCIS, RoboComp's simulator.

rcis-picture-size = The camera in RCIS sent a picture of { $bytes } bytes, which is not a 4:3 picture. Set the camera to an RGB picture such as 320 by 240.
