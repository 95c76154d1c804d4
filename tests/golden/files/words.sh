#!/bin/sh
# The words of a page or a picture, a block a line, without scripts, styles, and what is a number alone. What depends
# on the machine or the build is dots.
awk '/<(style|script)/ { hidden = 1 } !hidden { print } /<\/(style|script)>/ { hidden = 0 }' "$1" |
  sed -e 's/<\/\{0,1\}\(a\|b\|code\|span\|sub\|sup\|tspan\|i\|em\|strong\)\( [^>]*\)\{0,1\}>//g' -e 's/<[^>]*>/\n/g' |
  sed -e 's/&#8203;//g' -e 's/; [^;]*, threads [0-9]*;/; .../' | awk '
    skip && NF { skip = 0; next }
    /^(commit|compiler|cpu_level|dirty|host_cpu)$/ { print $0 " ..."; skip = 1; next }
    /[A-Za-z][A-Za-z]/'
