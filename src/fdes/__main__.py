"""`python -m fdes` is `fdes`."""

from fdes.cli import main

main()
