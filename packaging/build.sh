#!/usr/bin/env bash
# The steps from a fresh tree to an installed Selvage.  The Dockerfile runs them in its stages; the packaging test runs
# `configure`, and runs `install` on an existing build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'EOF'
usage: packaging/build.sh STEP

  build-packages         install the Debian packages needed to build (as root)
  run-packages           install those needed to run (as root)
  configure BUILD        configure the programs, without tests and benchmarks
  build BUILD            configure and build them
  install BUILD PREFIX   install them, stripped, below PREFIX
EOF
}

# install_packages NAME...
install_packages() {
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends "$@"
  rm -rf /var/lib/apt/lists/*
}

configure() {
  cmake --preset programs -B "$1"
}

case ${1:-} in
  build-packages)
    packages=$(packaging/packages.sh engine daemon)
    # shellcheck disable=SC2086
    install_packages $packages
    ;;
  run-packages)
    packages=$(grep -v '^#' packaging/packages-run.txt)
    # shellcheck disable=SC2086
    install_packages $packages
    ;;
  configure) configure "$2" ;;
  build)
    configure "$2"
    cmake --build "$2" --target selvaged selvage
    ;;
  install)
    for component in Command Daemon; do cmake --install "$2" --prefix "$3" --strip --component "$component"; done
    ;;
  *) usage; exit 2 ;;
esac
