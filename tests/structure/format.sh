#!/bin/sh
# Are all C++ files laid out as .clang-format says? Exit status 77, skipped: there is no clang-format 14.
set -u
cd "$(dirname "$0")/../.."
for format in clang-format-14 clang-format; do
  if "$format" --version 2>/dev/null | grep -q ' version 14\.'; then
    find modules src tests -name '*.[ch]pp' -print0 | xargs -0 "$format" --dry-run --Werror
    exit $?
  fi
done
echo "skipped: clang-format 14 is not installed"
exit 77
