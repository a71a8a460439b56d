#!/bin/bash
# Draws figures 8.1, 8.4, 8.5 and 8.8 of [Li94] from the examples of this folder, as docs/packing.md shows them.
#
# usage: draw_figures.sh SELVAGE FOLDER
set -euo pipefail
selvage=$1
folder=$2
examples=$(dirname "$0")

draw() {
  local picture=$1 motion=$2 marker=$3
  shift 3
  "$selvage" "$motion" "$examples/$marker" --svg "$folder/$picture.svg" "$@" > /dev/null
}

draw 8.1a show beside.json
draw 8.1b compact beside.json --rounds 1
draw 8.1c pack beside.json
draw 8.4a compact exchange.json
draw 8.4b pack exchange.json
draw 8.5a show seven.json
draw 8.5b compact seven.json
draw 8.5c pack seven.json
draw 8.8a show trims.json
draw 8.8b contain trims.json
