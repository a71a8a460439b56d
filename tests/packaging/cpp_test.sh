#!/usr/bin/env bash
# usage: cpp_test.sh SOURCE BUILD     installs the C++ libraries of the build into a folder and uses them from there, by
# CMake and by pkg-config, and uses the source tree as a part of another project
set -euo pipefail
source=$1
build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "failed: $*" >&2
  exit 1
}
cmake --install "$build" --prefix "$folder/usr" --component Development > /dev/null

# project NAME LINES...: a project of these lines, configured against the installed libraries
project() {
  mkdir -p "$folder/$1"
  {
    echo 'cmake_minimum_required(VERSION 3.25)'
    echo "project($1 LANGUAGES CXX)"
    printf '%s\n' "${@:2}"
  } > "$folder/$1/CMakeLists.txt"
  cmake -S "$folder/$1" -B "$folder/$1/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/usr" > "$folder/$1/log" 2>&1
}

project both 'find_package(Selvage 0.1 REQUIRED COMPONENTS core client)' \
  "add_executable(shorten $source/examples/core/shorten.cpp)" 'target_link_libraries(shorten PRIVATE Selvage::core)' \
  "add_executable(compact $source/examples/cpp/compact.cpp)" 'target_link_libraries(compact PRIVATE Selvage::client)' \
  'set_target_properties(shorten compact PROPERTIES EXPORT_COMPILE_COMMANDS ON)' || fail "$(< "$folder/both/log")"
cmake --build "$folder/both/build" > "$folder/both/log" 2>&1 || fail "$(< "$folder/both/log")"
shortened=$("$folder/both/build/shorten") || fail "the installed core"
grep -q ', valid' <<< "$shortened" || fail "the installed core does not compact: $shortened"
! grep -qE -- '-Werror|-Wconversion|-ffp-contract' "$folder/both/build/compile_commands.json" ||
  fail "our compile options reach other projects"

# The client needs none of the core's libraries.
project client 'set(CMAKE_DISABLE_FIND_PACKAGE_Eigen3 ON)' \
  'find_package(Selvage REQUIRED COMPONENTS client)' || fail "$(< "$folder/client/log")"
! project unknown 'find_package(Selvage REQUIRED COMPONENTS nonsense)' || fail "an unknown component was found"
grep -q 'no nonsense' "$folder/unknown/log" || fail "$(< "$folder/unknown/log")"

export PKG_CONFIG_PATH=$folder/usr/lib/pkgconfig
# shellcheck disable=SC2046
c++ -std=c++20 "$source/examples/core/shorten.cpp" -o "$folder/shorten" $(pkg-config --cflags --libs selvage) ||
  fail "pkg-config"
shortened=$("$folder/shorten") || fail "the program linked by pkg-config"
grep -q ', valid' <<< "$shortened" || fail "the program linked by pkg-config does not compact: $shortened"

# As a part of another project: the libraries alone, without tests, programs or our warnings.
project part "add_subdirectory($source selvage EXCLUDE_FROM_ALL)" \
  "add_executable(shorten $source/examples/core/shorten.cpp)" 'target_link_libraries(shorten PRIVATE Selvage::core)' ||
  fail "$(< "$folder/part/log")"
cmake --build "$folder/part/build" --target core_geometry > "$folder/part/log" 2>&1 || fail "$(< "$folder/part/log")"
targets=$(cmake --build "$folder/part/build" --target help)
! grep -qE ' (selvaged|selvage|geometry_test):' <<< "$targets" ||
  fail "more than the libraries is a part of other projects"
project fetched 'include(FetchContent)' "FetchContent_Declare(selvage SOURCE_DIR $source)" 'FetchContent_MakeAvailable(selvage)' \
  "add_executable(shorten $source/examples/core/shorten.cpp)" 'target_link_libraries(shorten PRIVATE Selvage::core)' ||
  fail "$(< "$folder/fetched/log")"
echo "installed, found, linked"
