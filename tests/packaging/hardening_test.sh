#!/usr/bin/env bash
# usage: hardening_test.sh SELVAGED     how the program is linked: what makes a mistake harder to exploit
set -euo pipefail
export LC_ALL=C
program=$1
fail() {
  echo "failed: $program $*" >&2
  exit 1
}
segments=$(readelf --wide --segments "$program")
dynamic=$(readelf --wide --dynamic "$program")
symbols=$(readelf --wide --dyn-syms "$program")

grep -q '^Elf file type is DYN' <<< "$segments" || fail "is not position-independent (PIE)"
grep -q 'GNU_RELRO' <<< "$segments" || fail "has no read-only relocations (RELRO)"
grep -Eq '\(FLAGS\).*BIND_NOW|\(FLAGS_1\).*NOW' <<< "$dynamic" || fail "binds its symbols late (BIND_NOW)"
! grep 'GNU_STACK' <<< "$segments" | grep -q 'RWE' || fail "has an executable stack"
grep -Eq ' __[a-z]+_chk(@|$)' <<< "$symbols" || fail "calls no function that checks sizes (_FORTIFY_SOURCE)"
