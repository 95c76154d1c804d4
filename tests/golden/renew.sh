#!/bin/sh
# Writes what the built program prints now into the transcripts of commands/; `git diff` then shows what was reworded.
#   renew.sh BUILD_FOLDER          all of them
#   renew.sh BUILD_FOLDER NAME...  these, e.g. run_point; a new one is a file commands/NAME.txt that contains only
#                                  commands, in lines as transcript.hpp describes
set -eu
build=$(cd "${1:?usage: renew.sh BUILD_FOLDER [NAME...]}" && pwd)
shift
cd "$(dirname "$0")/commands"
[ $# -gt 0 ] || set -- $(ls | sed 's/\.txt$//')
cmake --build "$build" --target tests_golden
EHL_RENEW_GOLDEN="$*" "$build/tests/golden/tests_golden" --run_test='*/the_program_prints_what_the_transcripts_say'
git diff --stat -- .
