"""The messages of the protocol as Python types: results, errors and edits, and their conversion from and to JSON."""
