#!/usr/bin/env bash
# usage: wheel_test.sh SOURCE SELVAGED WHEELS     installs the wheels of the folder into a fresh environment, and uses the
# engine there, compared with the daemon
set -euo pipefail
source=$1
selvaged=$2
wheels=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python=$(command -v /usr/bin/python3 || command -v python3)
"$python" -m venv "$folder/environment"
"$folder/environment/bin/pip" install --quiet --no-index --find-links "$wheels" selvage-engine
cd "$folder"
export PYTHONPATH=$source/tests/clients
timeout 300 "$folder/environment/bin/python" -B "$source/tests/clients/python_engine_test.py" "$selvaged"
