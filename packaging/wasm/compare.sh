#!/usr/bin/env bash
# Compares the WebAssembly program with the native command on the example markers: compare.sh FOLDER SELVAGE
# FOLDER has compact.wasm.  The answers must be valid, by the native check, and as short to a thousandth of a millimetre:
# the two differ by the solver of small programs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=$1
selvage=$2
length() { "$selvage" check "$1" | sed -n 's/.* length \([0-9.]*\) mm.*: valid$/\1/p'; }
for marker in "$here"/../../examples/markers/*.json; do
  name=$(basename "$marker" .json)
  node --no-warnings "$here/run.mjs" "$out/compact.wasm" < "$marker" > "$out/$name.json"
  "$selvage" compact "$marker" -o "$out/native.json" > /dev/null
  native=$(length "$out/native.json")
  portable=$(length "$out/$name.json") # empty when it is not valid
  echo "$name: $native native, $portable in WebAssembly"
  awk -v a="$native" -v b="$portable" 'BEGIN { exit !(a > 0 && b > 0 && (a - b) ^ 2 < 1e-6) }' || { echo "$name: not valid, or not so short" >&2; exit 1; }
done
