#!/usr/bin/env bash
# usage: deb_test.sh FOLDER [ROOT.tar]     installs the Debian packages of the folder in a clean Debian 12, uses and removes them
# there.  Needs root.  Without a tarball of a root, mmdebstrap makes one.
set -euo pipefail
packages=$(realpath "$1")
tarball=${2:-}
folder=$(mktemp -d)
root=$folder/root
trap 'umount -q "$root/proc" || true; rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}
inside() { DEBIAN_FRONTEND=noninteractive LC_ALL=C chroot "$root" "$@"; }

if [[ -n $tarball ]]; then
  mkdir "$root"
  tar -xf "$tarball" -C "$root"
else
  mmdebstrap --quiet --variant=minbase bookworm "$root"
fi
cp "$packages"/*.deb "$root/tmp"
mount -t proc proc "$root/proc"
inside apt-get update -q > "$folder/log" 2>&1 || fail "$(< "$folder/log")"

# The command can be installed with only its dependencies, and works.
inside sh -c 'apt-get install -yq --no-install-recommends /tmp/selvage_*.deb' > "$folder/log" 2>&1 || fail "$(tail -n 30 "$folder/log")"
cp examples/markers/jeans_02g.json "$root/tmp"
inside selvage compact /tmp/jeans_02g.json -o /tmp/out.json > "$folder/log" 2>&1 || fail "$(< "$folder/log")"
checked=$(inside selvage check /tmp/out.json) || fail "the installed command's check"
grep -q ': valid$' <<< "$checked" || fail "the installed command's marker"
files=$(inside dpkg -L selvage)
for file in usr/share/man/man1/selvage.1.gz usr/share/bash-completion/completions/selvage; do
  # minbase leaves documentation out if dpkg is configured so
  grep -qx "/$file" <<< "$files" || fail "$file is not in the package"
done

# The daemon, as its unit would start it.
inside sh -c 'apt-get install -yq --no-install-recommends /tmp/selvaged_*.deb curl' > "$folder/log" 2>&1 || fail "$(tail -n 30 "$folder/log")"
grep -q '^ExecStart=/usr/bin/selvaged --config /etc/selvage/selvaged.toml$' "$root/lib/systemd/system/selvaged.service" || fail "the unit"
inside mkdir -p /var/lib/selvage
inside selvaged --config /etc/selvage/selvaged.toml --check-config > /dev/null || fail "the installed configuration"
inside sh -c '
  selvaged --config /etc/selvage/selvaged.toml --listen 127.0.0.1:0 --port-file /tmp/port > /tmp/log 2>&1 &
  for _ in $(seq 100); do [ -s /tmp/port ] && break; sleep 0.1; done
  curl -sf "localhost:$(head -n 1 /tmp/port)/healthz"; healthy=$?
  kill $!; wait $!
  exit $healthy' > "$folder/log" || fail "the installed daemon: $(cat "$root/tmp/log")"
echo '# changed' >> "$root/etc/selvage/selvaged.toml"

# The libraries: a program is compiled against them.
inside sh -c 'apt-get install -yq --no-install-recommends /tmp/libselvage-dev_*.deb g++ pkg-config libc6-dev' > "$folder/log" 2>&1 ||
  fail "$(tail -n 30 "$folder/log")"
cp examples/core/shorten.cpp "$root/tmp"
inside sh -c 'c++ -std=c++20 /tmp/shorten.cpp -o /tmp/shorten $(pkg-config --cflags --libs selvage) && /tmp/shorten' > "$folder/log" 2>&1 ||
  fail "$(< "$folder/log")"
grep -q valid "$folder/log" || fail "the program that was compiled: $(< "$folder/log")"

# After removal the configuration remains; after a purge nothing does.
inside apt-get remove -yq selvage selvaged libselvage-dev > "$folder/log" 2>&1 || fail "$(< "$folder/log")"
[[ ! -e $root/usr/bin/selvage && ! -e $root/usr/bin/selvaged ]] || fail "programs are left after removal"
grep -q '# changed' "$root/etc/selvage/selvaged.toml" || fail "removal has lost the configuration"
inside apt-get purge -yq selvaged > "$folder/log" 2>&1 || fail "$(< "$folder/log")"
[[ ! -e $root/etc/selvage ]] || fail "the configuration is left after purge"
[[ -z $(find "$root/usr" "$root/lib" "$root/etc" -name '*selvage*' 2> /dev/null) ]] || fail "files are left after purge"
echo "installed, used, removed"
