#!/usr/bin/env bash
# usage: python_extras_test.sh SOURCE SELVAGED     installs the Python client with its extras from PyPI into a fresh environment,
# which then has the newest NumPy (2 or later), shapely, matplotlib and tqdm, and runs the client's tests and types there
set -euo pipefail
source=$(realpath "$1")
selvaged=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python=$(command -v /usr/bin/python3 || command -v python3)
"$python" -m venv "$folder/environment"
cp -r "$source/clients/python" "$folder/client"  # setuptools builds inside the source
"$folder/environment/bin/pip" install --quiet mypy spyrrow "$folder/client[outlines,drawing,progress]"
"$folder/environment/bin/python" -c 'import numpy; print("NumPy", numpy.__version__); assert int(numpy.__version__.split(".")[0]) >= 2'
cd "$folder"
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$source/tests/clients
for test in python_test python_methods_test python_nesting_test python_notebook_test; do
  timeout 600 "$folder/environment/bin/python" "$source/tests/clients/$test.py" "$selvaged" > "$folder/log" 2>&1 ||
    { cat "$folder/log" >&2; exit 1; }
  grep '^Ran' "$folder/log"
done
(cd "$folder/client" && "$folder/environment/bin/mypy" --config-file pyproject.toml --cache-dir "$folder/mypy" src)
