#!/bin/sh
# Fetches axe-core into a folder and checks the page with it: axe.sh FOLDER Exits with 77, which ctest reports as
# skipped, when npm's registry does not answer.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cp "$here/package.json" "$here/package-lock.json" "$1"
[ -f "$1/node_modules/axe-core/axe.min.js" ] || (cd "$1" && npm ci --no-audit --no-fund) || exit 77
AXE="$1/node_modules/axe-core/axe.min.js" exec node --test "$here/axe.mjs"
