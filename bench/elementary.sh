#!/usr/bin/env bash
# Instructions a call of each elementary function, of the C library's and of ours by both compilers: the table of
# docs/math.md. A few minutes.
set -euo pipefail
cd "$(dirname "$0")"
programs=$(mktemp -d)
trap 'rm -rf "$programs"' EXIT

by=("g++ -fno-tree-vectorize" "clang++-19 -fno-vectorize -fno-slp-vectorize" "g++ -fno-tree-vectorize -march=x86-64-v3" "clang++-19 -fno-vectorize -fno-slp-vectorize -march=x86-64-v3")
for i in "${!by[@]}"; do
  ${by[$i]%% *} -std=c++20 -O2 ${by[$i]#* } -I../include elementary.cpp -o "$programs/$i"
done

collected() { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | awk '/Collected/ { print $4 }'; }
instructions() { echo $((($(collected "$1" "$2" 2) - $(collected "$1" "$2" 1)) / 1024)); }

echo "| | glibc | g++ | clang | g++, v3 | clang, v3 |"
echo "|---|---|---|---|---|---|"
for f in sin cos sine_and_cosine tan asin acos atan atan2 exp expm1 log pow sinh cosh tanh cbrt hypot sqrt floor round fmod; do
  line="| $f | $(instructions "$programs/0" "c_$f")"
  for i in "${!by[@]}"; do line+=" | $(instructions "$programs/$i" "$f")"; done
  echo "$line |"
done
