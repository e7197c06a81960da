"""The offline page of one plan or of several: what it shows, and how it is put into one file."""
