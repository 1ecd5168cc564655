"""Input shapes, one file each: a frozen dataclass whose call gives the input's value at a time.

Its first field is the amplitude; the other fields are what may be said of it ("at 1 s", "for 2 s"). Every shape is
zero before it starts and never larger than its amplitude. A shape whose numbers are in a file offers `read` instead of
an amplitude: from file, column and unit it makes what stands before `at`.
"""
