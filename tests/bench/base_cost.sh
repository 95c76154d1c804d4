#!/bin/sh
# The cost of a case without effects for two builds of the program, before and after a change: instructions counted by
# valgrind, memory, and whether the results agree bit for bit. Both builds must have the same processor level; valgrind
# does not support AVX-512.
#   base_cost.sh OLD/ehl NEW/ehl [DECK]
set -eu
# If it is not set, the program sets it and restarts itself, which valgrind does not follow.
export GOMP_SPINCOUNT=3000
old=$(realpath "$1")
new=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
deck=$folder/small.ini
if [ $# -gt 2 ]; then
  cp "$3" "$deck"
else
  cat >"$deck" <<'DECK'
[contact]
M = 20
L = 10
[lubricant]
alpha = 2.2e-8
[domain]
x_inlet = -4.5
y_half = 3
[grid]
cells = 64
DECK
fi
cd "$folder"

instructions() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" run small.ini --threads 1 --quiet --output "$2.h5" 2>&1 |
    sed -n 's/.*Collected : *//p'
}
# The least of five runs, because the share of the system varies.
memory() {
  for _ in 1 2 3 4 5; do
    "$1" run small.ini --threads 1 --quiet --json --overwrite --output memory.h5 |
      sed -n 's/.*"peak_memory_bytes": *\([0-9]*\).*/\1/p'
  done | sort -n | head -n 1
}
compare() { awk -v n="$1" -v a="$2" -v b="$3" 'BEGIN { printf "%-13s %14.0f %14.0f  %+.3f %%\n", n, a, b, 100 * (b / a - 1) }'; }

compare instructions "$(instructions "$old" old)" "$(instructions "$new" new)"
compare "memory [B]" "$(memory "$old")" "$(memory "$new")"
for field in P H; do
  for name in old new; do "$new" extract $name.h5 $field | sed 1d >$name.txt; done
  if cmp -s old.txt new.txt; then echo "$field             the same bits"; else
    echo "$field             DIFFERS"
    exit 1
  fi
done
