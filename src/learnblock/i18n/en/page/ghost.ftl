# A real robot and its twin, while the user looks back.

page-ghost-legend = Ways of the robot and its twin
page-ghost-twin = Twin (prediction)
page-ghost-robot = Real robot
page-ghost-more = What it means, and what was not recorded
