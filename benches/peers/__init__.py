"""How each peer makes its own objects from a net, one file per peer.

A peer is imported when it is asked for: a question whose peers are missing can still be asked.
"""
