# Opening the page on another device.

page-device-title = Open on another device…
page-device-heading = Open on another device
page-device-scan = Scan this code with a phone or tablet in the same network. It opens this project.
page-device-code = QR code of the address of this project
page-device-address = Address
page-device-copy = Copy address
page-device-copied = Address copied.
page-device-secret = Everyone with this address can open and change all projects here.
page-device-alone = Only this computer can open the page. To open it on other devices too, stop LearnBlock and start it with:
