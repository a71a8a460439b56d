#!/usr/bin/env bash
# usage: packaging/deb.sh BUILD FOLDER     packs a finished build of daemon and command as Debian packages in FOLDER, and has
# lintian check them: selvage, selvaged, libselvage-dev
set -euo pipefail
build=$(realpath "$1")
mkdir -p "$2"
packages=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=$(sed -n 's/^project(selvage VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/selvage"
cp -r packaging/debian "$work/selvage"
cat > "$work/selvage/debian/changelog" <<END
selvage ($version) unstable; urgency=medium

  * CHANGELOG.md in the sources lists the changes.

 -- $(sed -n 's/^Maintainer: //p' packaging/debian/control)  $(date --utc -R -d "@$SOURCE_DATE_EPOCH")
END
(cd "$work/selvage" && SELVAGE_BUILD=$build dpkg-buildpackage --build=binary --no-sign --no-check-builddeps > "$work/log" 2>&1) ||
  { cat "$work/log" >&2; exit 1; }
rm -f "$packages"/*.deb
mv "$work"/*.deb "$packages"
lintian --allow-root --fail-on error "$packages"/*.deb
printf '%s\n' "$packages"/*.deb
