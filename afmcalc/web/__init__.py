"""The web page on which a clutch is designed live: it shows what the other packages calculate and draw."""
