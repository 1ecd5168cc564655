"""The web cockpit: a server that flies in real time, and a page to fly with.

`wire` is what server and page say to each other. `hub` steps every `session` in one thread; `cabins` seats those who
fly and watch, and `viewer` is one of them. `craft`, `fleet` and `replay` are what there is to fly and to show. `server`
is the application behind its `guard`, `files` serves the page, and `serve` runs it all.
"""

from fdes.cockpit.serve import serve

__all__ = ["serve"]
