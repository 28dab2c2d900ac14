"""The matrix of a script: situations × modules as a spreadsheet, and *what if*."""
