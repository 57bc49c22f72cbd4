# Un robot real y su gemelo, mientras se mira atrás.

page-ghost-legend = Recorridos del robot y de su gemelo
page-ghost-twin = Gemelo (predicción)
page-ghost-robot = Robot real
page-ghost-more = Qué significa, y qué no se registró
