#!/usr/bin/env bash
# Compacts a marker on a running selvaged, with curl: opens it, compacts it, saves its outlines, closes it.
#
#   examples/curl/compact.sh MARKER.json OUTLINES.json
#
# SELVAGED is the address of the daemon, by default 127.0.0.1:7171.
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 MARKER.json OUTLINES.json" >&2
  exit 2
fi
marker=$1 outlines=$2 server=${SELVAGED:-127.0.0.1:7171}

# rpc METHOD: reads the parameters from stdin and prints the result; after an error, the script ends with its message.
rpc() {
  { printf '{"jsonrpc":"2.0","id":1,"method":"%s","params":' "$1"; cat; printf '}'; } |
    curl --silent --show-error --fail --header 'Content-Type: application/json' \
      --data-binary @- "http://$server/rpc" |
    python3 -c '
import json, sys
answer = json.load(sys.stdin)
if "error" in answer:
    sys.exit("selvaged: " + answer["error"]["message"])
json.dump(answer["result"], sys.stdout)'
}
# field NAME: prints one field of the JSON object on stdin.
field() {
  python3 -c 'import json, sys; print(json.dumps(json.load(sys.stdin)[sys.argv[1]]).strip("\""))' "$1"
}

id=$({ printf '{"marker":'; cat "$marker"; printf '}'; } | rpc marker.open | field markerId)
compacted=$(printf '{"markerId":"%s"}' "$id" | rpc motion.compact)
printf '{"markerId":"%s","format":"outlines"}' "$id" | rpc marker.get | field marker >"$outlines"
printf '{"markerId":"%s"}' "$id" | rpc marker.close >/dev/null

echo "$marker: length $(field lengthBefore <<<"$compacted") -> $(field lengthAfter <<<"$compacted")," \
  "outlines in $outlines"
