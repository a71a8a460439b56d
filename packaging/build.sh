#!/usr/bin/env bash
# The steps that make an installed Selvage out of a fresh tree.  The Dockerfile runs them in its stages; the test of
# packaging runs `configure`, and `install` on the build that is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'EOF'
usage: packaging/build.sh STEP

  build-packages         install the Debian packages that building needs (as root)
  run-packages           install those that running needs (as root)
  configure BUILD        configure the programs, without tests and benchmarks
  build BUILD            configure and build them
  install BUILD PREFIX   install them, stripped, below PREFIX
EOF
}

# without comments
names_in() { grep -v '^#' "$1"; }

install_packages() {
  apt-get update -q
  names_in "$1" | DEBIAN_FRONTEND=noninteractive xargs apt-get install -yq --no-install-recommends
  rm -rf /var/lib/apt/lists/*
}

configure() {
  cmake -S . -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSELVAGE_TESTS=OFF -DSELVAGE_BENCH=OFF
}

case ${1:-} in
  build-packages) install_packages packaging/packages-build.txt ;;
  run-packages) install_packages packaging/packages-run.txt ;;
  configure) configure "$2" ;;
  build)
    configure "$2"
    cmake --build "$2" --target selvaged selvage
    ;;
  install) cmake --install "$2" --prefix "$3" --strip ;;
  *) usage; exit 2 ;;
esac
