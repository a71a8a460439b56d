#!/usr/bin/env bash
# usage: healthcheck.sh [PORT]     exit 0: the daemon on this machine is ready for work
# For plain HTTP; a daemon that speaks TLS itself is asked with curl instead.
set -euo pipefail
exec 3<> "/dev/tcp/127.0.0.1/${1:-7171}"
printf 'GET /readyz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n' >&3
IFS= read -r -t 5 status <&3
[[ $status == 'HTTP/1.1 200 '* ]]
