"""Connections to a daemon: addresses, one connection, the link that reconnects, and calls from other threads."""
