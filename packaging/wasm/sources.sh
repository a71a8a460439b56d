#!/usr/bin/env bash
# Fetches the sources of two libraries of which Debian's packages have only the native code: sources.sh FOLDER
# FOLDER then has clipper.cpp (Clipper 6.4) and pugixml.cpp, of the versions of Debian 12 whose headers the build uses.
set -euo pipefail
mkdir -p "$1/lists/partial"
cd "$1"
if [[ -f clipper.cpp && -f pugixml.cpp ]]; then exit; fi
echo 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main' > sources.list
# Lists of our own, because few systems list the sources.
apt=(apt-get -q -o Dir::Etc::SourceList="$PWD/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$PWD/lists")
"${apt[@]}" update
"${apt[@]}" source --download-only libpolyclipping pugixml
tar -xf libpolyclipping_*.orig.tar.bz2 --strip-components=2 --wildcards '*/cpp/clipper.cpp'
tar -xf pugixml_*.orig.tar.gz --strip-components=2 --wildcards '*/src/pugixml.cpp'
