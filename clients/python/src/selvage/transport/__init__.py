"""Connections to a daemon: addresses, the JSON-RPC link that reconnects, and blocking access to it."""
