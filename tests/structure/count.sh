#!/bin/bash
# Prints measures of the source tree as a table, for comparison with an earlier commit.
#   tests/structure/count.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
sources() { find "$@" -name '*.[ch]pp'; }
row() { printf '%-52s %7d\n' "$1" "$2"; }
count() { grep -rE --include='*.[ch]pp' "$@" | wc -l || true; }

row "lines, modules and src" "$(sources modules src | xargs cat | wc -l)"
row "lines, tests" "$(sources tests | xargs cat | wc -l)"
row "files, modules and src" "$(sources modules src | wc -l)"
# All includes from module a in module b count as one dependency.
row "arrows between modules" "$(grep -rHoE --include='*.[ch]pp' '^#include "(effects/)?[a-z_]+' modules |
  sed -E 's#^modules/((effects/)?[a-z_]+)/[^:]*:\#include "#\1 #' | awk '$1 != $2' | sort -u | wc -l)"
# In the layout of clang-format, a function ends with a brace in the first column.
row "functions over 60 lines" "$(sources modules src | xargs awk '
  FNR == 1 { start = 0 }
  /^[A-Za-z].*\{$/ && !/^(namespace|struct|class|enum|union)/ { start = FNR }
  /^[A-Za-z].*\($/ || /^[A-Za-z].*,$/ { if (!start) start = FNR }
  /^};?$/ { if (start && FNR - start + 1 > 60) n++; start = 0 }
  END { print n + 0 }')"
row "lines that say mirrored, outside core" "$(grep -rE --include="*.[ch]pp" "\bmirrored" modules src | grep -vc '^modules/core/' || true)"
row "places that ask a bool of cavitation" "$(count 'bool \w*cavitat|cavitat\w*\)? *[?]|if \(!?[^)]*cavitat' modules src)"
row "words in READMEs" "$(find . -name README.md -not -path './build/*' -print0 | xargs -0 cat | wc -w)"
