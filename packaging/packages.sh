#!/usr/bin/env bash
# usage: packaging/packages.sh GROUP...     prints the packages of these groups of packages.txt, one per line
set -euo pipefail
list=$(dirname "${BASH_SOURCE[0]}")/../packages.txt
for group in "$@"; do
  awk -v header="[$group]" '
    /^\[/ { inside = $0 == header }
    inside && !/^(\[|#|$)/ { print; found = 1 }
    END { exit !found }' "$list" || { echo "packages.txt has no group $group" >&2; exit 1; }
done
