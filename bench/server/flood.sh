#!/usr/bin/env bash
# What a flood of quick calls leaves to motions and to other programs, with real-time priorities and without: clients read,
# bump and open markers as fast as they are answered, while another client compacts in a loop and a program of no
# privilege computes on every processor.  The clients of the flood run before both (nice -20), because they would be on
# other machines.
#
# usage: flood.sh DIRECTORY_OF_PROGRAMS [SECONDS]      as root
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bin=${1:?usage: flood.sh DIRECTORY_OF_PROGRAMS [SECONDS]}
seconds=${2:-10}
folder=$(mktemp -d)
started=()
trap 'kill "${started[@]}" 2> /dev/null; wait; rm -rf "$folder"' EXIT

# ticks PID...: the processor time of these processes, in hundredths of a second
ticks() {
  local sum=0 own
  for process in "$@"; do
    own=$(sed 's/.*) //' "/proc/$process/stat" | cut -d ' ' -f 12,13)
    sum=$((sum + ${own% *} + ${own#* }))
  done
  echo "$sum"
}

# flood REAL_TIME: one row of the table
flood() {
  local port daemon clients=() others=() before after
  rm -f "$folder/port"
  "$bin/selvaged" --listen 127.0.0.1:0 --port-file "$folder/port" --log-level warn --real-time "$1" > "$folder/log" 2>&1 &
  daemon=$!
  started+=("$daemon")
  until [[ -s $folder/port ]]; do sleep 0.05; done
  port=$(head -n 1 "$folder/port")
  for _ in $(seq "$(nproc)"); do
    (while :; do :; done) &
    others+=($!)
  done
  started+=("${others[@]}")
  "$bin/server_load" "$port" examples/markers/jeans_22g.json compact 1 "$seconds" > "$folder/compact" &
  clients+=($!)
  for load in "get 8" "bump 8"; do
    # shellcheck disable=SC2086
    nice -n -20 "$bin/server_load" "$port" examples/markers/jeans_06g.json $load "$seconds" > "$folder/${load% *}" &
    clients+=($!)
  done
  sleep 1
  before="$(ticks "$daemon") $(ticks "${others[@]}")"
  sleep "$((seconds - 2))"
  after="$(ticks "$daemon") $(ticks "${others[@]}")"
  wait "${clients[@]}"
  kill "$daemon" "${others[@]}"
  echo "--real-time $1: of $(nproc) processors, $(awk -v s="$((seconds - 2))" -v before="$before" -v after="$after" 'BEGIN {
    split(before, b); split(after, a)
    printf "the daemon has %.2f and other programs have %.2f", (a[1] - b[1]) / 100 / s, (a[2] - b[2]) / 100 / s }')"
  sed 's/^/  /' "$folder/compact" "$folder/get" "$folder/bump"
}

flood off
flood on
