#!/usr/bin/env bash
# Starts selvaged and measures it under load: reads over HTTP, then bumps and drag sessions over a WebSocket, first
# alone and then while another client compacts in a loop.
#
# usage: server_load.sh DIRECTORY_OF_PROGRAMS [SECONDS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bin=${1:?usage: server_load.sh DIRECTORY_OF_PROGRAMS [SECONDS]}
seconds=${2:-5}
folder=$(mktemp -d)
port_file=$folder/port
"$bin/selvaged" --listen 127.0.0.1:0 --port-file "$port_file" --log-level warn > "$folder/log" 2>&1 &
daemon=$!
trap 'kill "$daemon" 2> /dev/null; wait "$daemon" 2> /dev/null; rm -rf "$folder"' EXIT
until [[ -s $port_file ]]; do sleep 0.05; done
port=$(head -n 1 "$port_file")
port=${port##*:}
load() { "$bin/server_load" "$port" "$@"; }
load examples/markers/jeans_06g.json get 1 "$seconds"
load examples/markers/jeans_06g.json get 4 "$seconds"
load examples/markers/jeans_06g.json bump 1 "$seconds"
load examples/markers/jeans_06g.json place 1 "$seconds"
load examples/markers/jeans_06g.json push 1 "$seconds"
echo "while another client compacts jeans_22g in a loop:"
load examples/markers/jeans_22g.json compact 1 "$((3 * seconds + 2))" > "$folder/compact" &
compacting=$!
sleep 1
load examples/markers/jeans_06g.json get 1 "$seconds"
load examples/markers/jeans_06g.json bump 1 "$seconds"
load examples/markers/jeans_06g.json push 1 "$seconds"
wait "$compacting"
cat "$folder/compact"
