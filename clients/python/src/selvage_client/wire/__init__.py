"""Communication with a daemon: addresses, a connection, the link that reconnects, and calls from other threads."""
