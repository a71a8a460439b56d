#!/usr/bin/env bash
# Builds the core and the marker formats for WebAssembly: build.sh OUT CLIPPER
# OUT is a folder; compact.wasm is made in it.  CLIPPER is the folder with the source of Clipper 6.4 (clipper.cpp).
# Needs Debian's clang-16, lld-16, libc++-16-dev-wasm32, libc++abi-16-dev-wasm32, libclang-rt-16-dev-wasm32 and wasi-libc,
# and the headers that the native build needs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
out=$1
clipper=$2
mkdir -p "$out/headers" "$out/objects"
# Of the host's headers only those that have no library: the C library is that of WebAssembly.
for name in boost eigen3/Eigen polyclipping nlohmann; do ln -sfn "/usr/include/$name" "$out/headers/$(basename "$name")"; done

# compiled FILE: compiles one source, and names it when that fails
compiled() {
  local object
  object=$out/objects/$(printf '%s' "$1" | tr / _).o
  clang++-16 --target=wasm32-wasi -std=c++20 -O2 -ffp-contract=off -fexceptions -w -c "$1" -o "$object" \
    -nostdinc++ -isystem /usr/lib/llvm-16/include/wasm32-wasi/c++/v1 -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES \
    -DJSON_HAS_FILESYSTEM=0 -DJSON_HAS_EXPERIMENTAL_FILESYSTEM=0 -D_WASI_EMULATED_SIGNAL \
    -I"$here/shims" -include "$here/shims/one_thread.h" -I"$out/headers" -I"$root" || { echo "$1 does not compile" >&2; return 1; }
}
export -f compiled
export here root out

core=(core/base core/geometry core/outline core/minkowski core/lp core/marker core/model core/scene core/motion)
formats=(protocol/json protocol/document protocol/drawing protocol/formats)
cd "$root"
{
  find "${core[@]}" "${formats[@]}" -name '*.cpp' ! -path core/lp/solver/clp.cpp ! -path 'core/lp/integer/*'
  printf '%s\n' "$here/without.cpp" "$here/compact.cpp" "$clipper/clipper.cpp"
} | xargs -P "$(nproc)" -I{} bash -c 'compiled "$1"' _ {}
clang++-16 --target=wasm32-wasi -L/usr/lib/llvm-16/lib/wasm32-wasi -Wl,--gc-sections -Wl,-s -o "$out/compact.wasm" "$out"/objects/*.o -lc++ -lc++abi
