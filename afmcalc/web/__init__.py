"""The page on which a clutch is designed live: what the other rooms calculate and draw, over HTTP."""
