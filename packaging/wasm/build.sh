#!/usr/bin/env bash
# Builds the engine for WebAssembly: build.sh OUT SOURCES
# OUT is a folder; two programs are made in it: compact.wasm, which compacts a marker, and engine.wasm, which answers a page's
# calls.  SOURCES is the folder with clipper.cpp and pugixml.cpp that sources.sh fetches.
# Needs the group wasm of packages.txt, and the headers that the native build needs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
mkdir -p "$1/headers" "$1/objects"
out=$(cd "$1" && pwd)
sources=$(cd "$2" && pwd)
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
cache=$(command -v ccache || true)
# Of the host's headers only those that have no library: the C library is that of WebAssembly.
for name in boost eigen3/Eigen polyclipping nlohmann pugixml.hpp pugiconfig.hpp; do ln -sfn "/usr/include/$name" "$out/headers/$(basename "$name")"; done

# The header that CMake writes in the native build.
mkdir -p "$out/headers/protocol/describe"
template=$(< "$root/protocol/describe/marker_schema_text.h.in")
schema=$(< "$root/protocol/marker.schema.json")
printf '%s\n' "${template/@marker_schema@/"$schema"}" > "$out/headers/protocol/describe/marker_schema_text.h"

# sources_of FOLDER...: what is compiled of these folders and those in them
sources_of() {
  find "$@" -name '*.cpp' ! -path core/lp/solver/clp.cpp ! -path core/lp/integer/cbc.cpp ! -path 'server/store/disk/*' \
    ! -path 'server/store/library/*' ! -path server/store/journal.cpp ! -path server/store/verification.cpp \
    ! -path server/jobs/deadline_clock.cpp ! -path server/jobs/prompt_thread.cpp ! -path server/jobs/real_time_share.cpp \
    ! -path server/jobs/scheduling.cpp | sort
}

# units FILE...: for each folder a source that includes all of it, which is compiled faster than each of them
units() {
  printf '%s\n' "$@" | awk -v objects="$out/objects" '{
    unit = $0
    sub("/[^/]*$", "", unit)
    gsub("/", "_", unit)
    unit = objects "/" unit ".cpp"
    if (!(unit in known)) units[++count] = unit
    known[unit]
    printf "#include \"%s\"\n", $0 > unit
  } END {
    for (k = 1; k <= count; ++k) { close(units[k]); print units[k] }
  }'
}

# compiled FILE: compiles one source, and names it when that fails; only what computes long is optimised fully
compiled() {
  local object optimised=-O1
  if [[ ${1#"$out/objects/"} == core_* ]]; then optimised=-O2; fi
  object=$out/objects/$(printf '%s' "${1#"$out/objects/"}" | tr / _).o
  $cache clang++-16 --target=wasm32-wasi -std=c++20 $optimised -ffp-contract=off -fexceptions -w -c "$1" -o "$object" \
    -nostdinc++ -isystem /usr/lib/llvm-16/include/wasm32-wasi/c++/v1 -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES \
    -DJSON_HAS_FILESYSTEM=0 -DJSON_HAS_EXPERIMENTAL_FILESYSTEM=0 -D_WASI_EMULATED_SIGNAL -DSELVAGE_VERSION="\"$version\"" \
    -DPUGIXML_NO_EXCEPTIONS -I"$here/shims" -include "$here/shims/one_thread.h" -I"$out/headers" -I"$out/headers/polyclipping" -I"$root" || { echo "$1 does not compile" >&2; return 1; }
}
export -f compiled
export here root out version cache

# linked PROGRAM MAIN OPTION...: the program whose source is MAIN; what it does not use is left out
linked() {
  local program=$1 main=$2 others
  shift 2
  mapfile -t others < <(printf '%s\n' "$out"/objects/*.o | grep -v -e '_wasm_compact.cpp.o$' -e '_wasm_engine.cpp.o$')
  clang++-16 --target=wasm32-wasi -L/usr/lib/llvm-16/lib/wasm32-wasi -Wl,--gc-sections -Wl,-s "$@" -o "$out/$program" \
    "$out"/objects/*"_wasm_$main.cpp.o" "${others[@]}" -lc++ -lc++abi
}

cd "$root"
rm -f "$out"/objects/*
mapfile -t parts < <(
  sources_of core protocol server/{calls,changes,dispatch,drags,jobs,library,memory,methods,store} | grep -v '^protocol/methods/'
  echo server/ops/freed_memory.cpp)
{
  units "${parts[@]}"
  sources_of protocol/methods # whose sources use the same local names
  printf '%s\n' "$here"/{clock,without,compact,engine}.cpp "$sources"/{clipper,pugixml}.cpp
} | xargs -P "$(nproc)" -I{} bash -c 'compiled "$1"' _ {}
linked compact.wasm compact
linked engine.wasm engine -mexec-model=reactor
