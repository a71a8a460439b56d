#!/usr/bin/env bash
# usage: packaging_test.sh SOURCE BUILD     installs the build into a folder and lives through a day of its life there
set -euo pipefail
source=$1
build=$2
folder=$(mktemp -d)
daemon=
trap 'if [[ -n $daemon ]]; then kill -KILL "$daemon" 2> /dev/null || true; fi; rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}

# The lists of packages: what building needs is among what the project needs.
while read -r package; do
  [[ $package == \#* ]] && continue
  grep -qx "$package" "$source/packages.txt" || fail "$package is not in packages.txt"
done < "$source/packaging/packages-build.txt"

# The step that the Dockerfile runs, and what must have come of it.
"$source/packaging/build.sh" install "$build" "$folder/usr" > /dev/null
for file in bin/selvaged bin/selvage libexec/selvage/healthcheck.sh lib/systemd/system/selvaged.service; do
  [[ -f $folder/usr/$file ]] || fail "$file was not installed"
done
selvaged=$folder/usr/bin/selvaged
"$selvaged" --version | grep -q '^selvaged [0-9]' || fail "--version"

# Every library it links comes with the packages that the image installs.
mapfile -t packages < <(grep -v '^#' "$source/packaging/packages-run.txt")
known=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces \
  --no-enhances "${packages[@]}" libc6 libstdc++6 2> /dev/null | grep '^[a-z]' | sort -u)
for library in $(ldd "$selvaged" "$folder/usr/bin/selvage" | awk '$2 == "=>" {print $3}' | sort -u); do
  package=$({ dpkg-query -S "$library" "$(readlink -f "$library")" "/usr$library" 2> /dev/null || true; } |
    head -n 1 | cut -d: -f1)
  grep -qx "$package" <<< "$known" || fail "$library is of '$package', which the image does not install"
done

# The container's configuration, moved into the folder.
printf 'a token of the test only\n' > "$folder/token"
sed -e "s|/run/secrets/selvage-token|$folder/token|; s|/var/lib/selvage|$folder|; s|0.0.0.0:7171|0.0.0.0:0|" \
  "$source/packaging/container.toml" > "$folder/selvaged.toml"
"$selvaged" --config "$folder/selvaged.toml" --check-config > /dev/null || fail "--check-config"
! "$selvaged" --config "$source/packaging/container.toml" --check-config 2> "$folder/refusal" || fail "no token was missed"
grep -q -- '--token-file' "$folder/refusal" || fail "the refusal does not name --token-file"

"$selvaged" --config "$folder/selvaged.toml" --port-file "$folder/port" > /dev/null 2> "$folder/log" &
daemon=$!
for _ in $(seq 600); do
  [[ -s $folder/port ]] && break
  sleep 0.1
done
port=$(< "$folder/port")
healthcheck=$folder/usr/libexec/selvage/healthcheck.sh
"$healthcheck" "$port" || fail "the healthcheck of a daemon that is ready"
kill -TERM "$daemon"
wait "$daemon" || fail "exit code $? after SIGTERM: $(< "$folder/log")"
daemon=
! "$healthcheck" "$port" 2> /dev/null || fail "the healthcheck of a daemon that is gone"

# The unit's words are those that systemd knows; its paths are those of the folder.
if command -v systemd-analyze > /dev/null; then
  sed "s|/usr/bin/selvaged|$selvaged|" "$source/packaging/selvaged.service" > "$folder/selvaged.service"
  complaints=$(systemd-analyze verify "$folder/selvaged.service" 2>&1 | grep 'selvaged.service' | grep -v 'man ' || true)
  [[ -z $complaints ]] || fail "$complaints"
fi
echo "installed, ready, drained"
