# Conducción manual.

page-drive-title = Conducción manual
page-drive-stick = Palanca de mando
page-drive-keys = Arrastra la palanca, o pulsa las flechas o W, A, S y D.
page-drive-runs = Un programa está moviendo el robot. Páralo para conducirlo tú.
