#!/bin/sh
# Checks the layout of all C++ files against .clang-format. Exit status 77 (skipped) if clang-format 14 is missing.
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
