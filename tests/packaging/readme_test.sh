#!/usr/bin/env bash
# usage: readme_test.sh SOURCE     runs the commands of README.md, as they stand there, in a fresh clone of the source
#
# Commands are the lines of indented blocks that begin with "$ ", and those of the block after "On Debian 12:", of which
# ./dev test is left out, because that is what runs this test.  Lines about containers are left out where there is no
# docker.  The daemon runs until the end; it must be free to listen on port 7171.
set -euo pipefail
source=$(realpath "$1")
folder=$(mktemp -d)
daemon=
trap 'if [[ -n $daemon ]]; then kill "$daemon" 2> /dev/null || true; fi; rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}
git clone --quiet "$source" "$folder/selvage"
cd "$folder/selvage"

# The commands in their order; a line that ends in a backslash goes on.
mapfile -t commands < <(awk '
  /^On Debian 12:/ { plain = 1 }
  /^##/ { plain = 0 }
  going_on || /^    \$ / || (plain && /^    \.\//) {
    line = $0
    sub(/^    (\$ )?/, "", line)
    sub(/  +#.*/, "", line)
    going_on = sub(/\\$/, "", line)
    printf "%s%s", line, going_on ? " " : "\n"
  }' README.md)
((${#commands[@]} >= 4)) || fail "README.md has ${#commands[@]} commands"
for command in "${commands[@]}"; do
  echo "\$ $command"
  case $command in
    *'./dev test'*) ;;
    *selvaged*)
      bash -c "exec $command" > "$folder/log" 2>&1 &
      daemon=$!
      for _ in $(seq 100); do
        curl -s localhost:7171/healthz > /dev/null && break
        sleep 0.1
      done
      curl -s localhost:7171/healthz > /dev/null || fail "$command: $(< "$folder/log")"
      ;;
    *) bash -c "set -euo pipefail; $command" > "$folder/log" 2>&1 || fail "$command: $(tail -n 30 "$folder/log")" ;;
  esac
done
[[ -n $daemon ]] || fail "no command of README.md starts the daemon"
echo "${#commands[@]} commands of README.md have run"
