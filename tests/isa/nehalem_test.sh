#!/bin/sh
# nehalem_test.sh PROGRAM: the program runs on a processor without AVX, picks the baseline there, and renders the picture
# of this processor to the bit. 77, which ctest takes for skipped, without an emulator.
set -eu
command -v qemu-x86_64 >/dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

old() { qemu-x86_64 -cpu Nehalem "$@"; }

old "$1" info --build
old "$1" info --build | grep -q 'used here: *baseline, 4 paths'
for scene in cornell-box cornell-city:100; do # without Embree, and with it
  old "$1" render $scene --size 16x16 --spp 4 -q -o "$folder/old.exr"
  "$1" render $scene --size 16x16 --spp 4 -q -o "$folder/new.exr"
  "$1" diff "$folder/old.exr" "$folder/new.exr" | grep '^max  *0$'
done
if old "$1" render cornell-box --isa avx2 2>"$folder/error"; then exit 1; fi
grep 'this processor has no avx2' "$folder/error"
