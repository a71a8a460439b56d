#!/bin/sh
# Builds the package and runs its tests against a daemon: check.sh SELVAGED FOLDER.  The package is copied into the folder and
# built there.  The exit code is 77 if node or a TypeScript compiler (tsc, or the one that `npm ci` installs) is missing.
# WebSockets are those of Node, of `npm ci`, or of Debian's node-ws; without any of them the tests fail.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
export SELVAGED="$1"
copy="$2/clients/typescript"
tsc=$(command -v tsc || echo "$here/node_modules/.bin/tsc")
command -v node >/dev/null || { echo "skipped: node is not installed"; exit 77; }
[ -x "$tsc" ] || { echo "skipped: tsc is not installed; install node-typescript, or run npm ci in $here"; exit 77; }
rm -rf "$2"
mkdir -p "$copy" "$2/tests/golden" "$2/examples"
cp -r "$here/package.json" "$here/tsconfig.json" "$here/src" "$here/scripts" "$here/test" "$copy"
ln -s "$here/../../protocol" "$2/protocol"
ln -s "$here/../../tests/golden/rpc" "$2/tests/golden/rpc"
ln -s "$here/../../examples/typescript" "$2/examples/typescript"
ln -s "$here/../../examples/markers" "$2/examples/markers"
[ ! -d "$here/node_modules" ] || ln -s "$here/node_modules" "$copy/node_modules"
cd "$copy"
"$tsc"
export NODE_PATH=/usr/share/nodejs
exec node --test test/*.test.mjs
