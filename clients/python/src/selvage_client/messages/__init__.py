"""The messages of the protocol as Python values: results, errors, edits, and how they are read and written."""
