# The control of widths.cmake: one line of this file is wider than 110 columns, which the test must notice and refuse.
