#!/usr/bin/env bash
# Bundles the page: build.sh FOLDER EXAMPLES.  It writes index.html and the files that it refers to into FOLDER; their names
# contain the hash of their content.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=$1
examples=$2
rm -rf "$out"
mkdir -p "$out"

# hashed FILE NAME: copies a file to NAME with its hash before the extension, and prints that name
hashed() {
  local sum name
  sum=$(sha256sum "$1" | cut -c 1-10)
  name=${2%.*}-$sum.${2##*.}
  cp "$1" "$out/$name"
  printf '%s' "$name"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
esbuild "$here/main.ts" --bundle --minify --format=esm --target=es2022 --charset=utf8 --log-level=warning --outfile="$work/room.js"
# The first example is opened if the daemon has no marker yet.
list=
for name in jeans_02g charlie_04g simon_06g jeans_06g jeans_22g; do
  list+="${list:+,}{\"name\":\"$name\",\"file\":\"$(hashed "$examples/$name.json" "$name.json")\"}"
done
printf '[%s]\n' "$list" > "$work/examples.json"
script=$(hashed "$work/room.js" room.js)
style=$(hashed "$work/room.css" room.css)
icon=$(hashed "$here/icon.svg" icon.svg)
index=$(hashed "$work/examples.json" examples.json)
sed -e "s/@room.js@/$script/" -e "s/@room.css@/$style/" -e "s/@icon.svg@/$icon/" -e "s/@examples.json@/$index/" "$here/index.html" > "$out/index.html"
