#!/usr/bin/env bash
# usage: npm_test.sh SOURCE SELVAGED     packs the npm package in a fresh clone, installs it in a project of its own, compiles
# every TypeScript block of its README there, and runs them against a daemon.  77 when there is no npm or tsc.
set -euo pipefail
source=$1
selvaged=$2
command -v npm > /dev/null || { echo "skipped: there is no npm"; exit 77; }
command -v tsc > /dev/null || { echo "skipped: there is no tsc"; exit 77; }
folder=$(mktemp -d)
daemon=
trap 'if [[ -n $daemon ]]; then kill "$daemon" 2> /dev/null || true; fi; rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}

# Uses a fresh clone, without files of earlier builds.
mkdir "$folder/clone"
(cd "$source" && git ls-files -z --cached --others --exclude-standard clients/typescript | xargs -0 cp --parents -t "$folder/clone")
cd "$folder/clone/clients/typescript"
[[ ! -e dist ]] || fail "dist is a part of the sources"
npm pack --silent --offline --pack-destination "$folder" > "$folder/log" 2>&1 || fail "$(< "$folder/log")"
tarball=$(echo "$folder"/selvage-client-*.tgz)
held=$(tar -tzf "$tarball")
for file in dist/index.js dist/index.d.ts dist/lines.js dist/lines.d.ts dist/methods/documents.d.ts package.json README.md; do
  grep -qx "package/$file" <<< "$held" || fail "$file is not in the package"
done
! grep -qE 'test|scripts|node_modules' <<< "$held" || fail "more than the package is in it"

mkdir "$folder/project"
cd "$folder/project"
echo '{ "type": "module" }' > package.json
npm install --silent --offline --no-audit --no-fund "$tarball" > "$folder/log" 2>&1 || fail "$(< "$folder/log")"
# Each block that is marked as TypeScript is a program.
awk '/^```ts$/ { number += 1; inside = 1; next } /^```$/ { inside = 0 } inside { print > ("block" number ".ts") }' \
  node_modules/selvage-client/README.md
ls block*.ts > /dev/null || fail "the README has no TypeScript block"
# compile MODULE RESOLUTION [OPTION]
compile() {
  tsc --strict --target ES2022 --module "$1" --moduleResolution "$2" --lib ES2022,DOM "${@:3}" block*.ts > "$folder/log" ||
    fail "$(< "$folder/log")"
}
compile node16 node16 --noEmit
compile ES2022 node

"$selvaged" --listen 127.0.0.1:0 --port-file "$folder/port" --log-level off > /dev/null &
daemon=$!
for _ in $(seq 100); do
  [[ -s $folder/port ]] && break
  sleep 0.1
done
for program in block*.js; do
  sed -i "s/7171/$(head -n 1 "$folder/port")/" "$program"
  timeout 60 node "$program" > "$folder/log" || fail "$program: $(< "$folder/log")"
done
[[ $(tail -n 1 "$folder/log") == 800 ]] || fail "the README's program has printed: $(< "$folder/log")"
echo "packed, installed, compiled, run"
