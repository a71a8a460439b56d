#!/usr/bin/env bash
# Counts the instructions of compacting markers at accuracy standard, from marker value to result, with callgrind: cold
# (an empty cache of sums) and warm.  For comparison, the thesis reports 20 s on a machine of 28 million instructions
# per second for a marker of 120 pieces [Li94 4.1.5].  Prints a Markdown table.
# usage: instructions.sh DIRECTORY_OF_PROGRAMS MARKER...
set -euo pipefail
bin=${1:?usage: instructions.sh DIRECTORY_OF_PROGRAMS MARKER...}
shift
thesis=560000000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count() {  # FUNCTION MARKER
  valgrind --tool=callgrind --toggle-collect="selvage::bench::$1*" --callgrind-out-file="$folder/$1" \
    "$bin/compact_once" "$2" 2> "$folder/log" || { cat "$folder/log" >&2; return 1; }
  sed -n 's/^.*Collected : \([0-9]*\)$/\1/p' "$folder/log"
}

echo "| marker | cold | of the thesis' 5.6e8 | warm | of the thesis' 5.6e8 |"
echo "|---|---|---|---|---|"
for marker; do
  cold=$(count compact_cold "$marker")
  warm=$(count compact_warm "$marker")
  awk -v name="$(basename "$marker" .json)" -v cold="$cold" -v warm="$warm" -v thesis="$thesis" 'BEGIN {
    printf "| %s | %.3g | %.3f | %.3g | %.3f |\n", name, cold, cold / thesis, warm, warm / thesis }'
done
