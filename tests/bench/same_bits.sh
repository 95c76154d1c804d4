#!/bin/bash
# Checks that two builds of the program give the same bits: solves decks with both (one thread) and compares H00, P, H
# and, in time, the history. Both builds must have the same processor level.
#   same_bits.sh OLD/ehl NEW/ehl [case...]      exit status 1 where a case differs
set -u
old=$(realpath "$1")
new=$(realpath "$2")
shift 2
inputs=$(realpath "$(dirname "$0")/../../inputs")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# name, deck, overrides; --accuracy first: the program chooses mesh and domain
cases() {
  cat <<'TABLE'
default venner1992_M50_L10.ini
threads venner1992_M50_L10.ini --threads 2 --set grid.cells=512
upstream1 venner1992_M50_L10.ini --set discretization.wedge=upstream1
fft venner1992_M50_L10.ini --set deformation.method=fft
direct venner1992_M50_L10.ini --set deformation.method=direct --set grid.cells=64
mlmi4 venner1992_M50_L10.ini --set deformation.order=4
tolerance venner1992_M50_L10.ini --set multigrid.tolerance=1e-9
decimation venner1992_M50_L10.ini --set multigrid.line_solver=decimation --set multigrid.kernel_terms=5
vcycle venner1992_M50_L10.ini --set multigrid.cycle=V --set multigrid.post=1
table1 venner1992_table1.ini
light light_M5_L2.ini
barus venner_book_M20_L10_barus.ini
mourier mourier2006_smooth.ini
M1000 hard/M1000_L20.ini
M20L25 hard/M20_L25.ini
M2L0 hard/M2_L0.ini
ball4 hard/steel_ball_4GPa.ini
aspect hard/mesh_aspect_M20_L10.ini
continuation hard/load_continuation.ini
newton venner1992_M50_L10.ini --set multigrid.polish=always --set grid.cells=128
newton1 venner1992_M50_L10.ini --set multigrid.polish=always --set grid.cells=64 --set discretization.wedge=upstream1
aslant elliptic/oblique_M100_L10.ini
roller elliptic/crowned_roller.ini
wide elliptic/wide_M100_L10.ini
slender elliptic/slender_M20_L10.ini
squalane fluids/squalane.ini
yasutomi fluids/yasutomi.ini
table fluids/table.ini
eyring friction/traction_eyring.ini --set grid.cells=128
eyring_newton friction/traction_eyring.ini --set grid.cells=64 --set multigrid.polish=always
limit friction/traction_limit.ini --set grid.cells=128
ridge surfaces/stationary_ridge.ini --set grid.cells=128
map surfaces/measured_map.ini --set grid.cells=128
dry_rough surfaces/dry_roughness.ini
dry_hertz subsurface/dry_hertz.ini
stress subsurface/venner1992_M50_L10.ini
bump transient/bump.ini --set grid.cells=64 --set transient.end_time=0.6
load_step transient/load_step.ini --set grid.cells=64
impact transient/impact.ini --set grid.cells=64
vibration transient/vibration.ini --set grid.cells=64
line line/M20_L5.ini
starved starved/M50_L10.ini --set grid.cells=128
starved_line line/starved.ini
heat thermal/squalane.ini --set grid.cells=128
hot_line thermal/line.ini
starved_heat thermal/starved.ini --set grid.cells=64
dent transient/dent_M1000_L10.ini --set grid.cells=128 --set transient.end_time=0.2
accuracy venner1992_M50_L10.ini --accuracy
TABLE
}
solve() { # arguments: program, name, deck, options; prints result and history as text
  local program=$1 name=$2 deck=$3
  shift 3
  if [ "${1:-}" = --accuracy ]; then
    sed "/^\(cells\|x_\|y_\|far_field\|.domain.\|.grid.\)/d" "$inputs/$deck" >"$folder/accuracy.ini"
    set -- --set grid.accuracy=0.01
    deck=$folder/accuracy.ini
  else
    deck=$inputs/$deck
  fi
  case " $* " in *" --threads "*) ;; *) set -- "$@" --threads 1 ;; esac
  rm -f "$folder/$name.h5" "$folder/$name.xmf"
  "$program" run "$deck" "$@" --quiet --json --output "$folder/$name.h5" 2>/dev/null |
    sed 's/"formulas".*"warnings"/"warnings"/' | grep -o '"\(H00\|Hc\|Hm\|converged\|steps\|mu\)": *[^,}]*' | tr -d ' '
  for data in P H transient/Hc transient/Hm transient/H00 transient/T; do
    "$program" extract "$folder/$name.h5" $data 2>/dev/null | grep -v '^#'
  done
}
differ=0
while read -r name deck options; do
  [ $# -eq 0 ] || case " $* " in *" $name "*) ;; *) continue ;; esac
  # shellcheck disable=SC2086 # words
  sum_old=$(solve "$old" "$name" "$deck" $options | tee "$folder/$name.old" | cksum)
  sum_new=$(solve "$new" "$name" "$deck" $options | tee "$folder/$name.new" | cksum)
  lines=$(wc -l <"$folder/$name.old")
  if [ "$sum_old" = "$sum_new" ] && [ "$lines" -gt 100 ]; then verdict="the same bits"; else
    differ=1
    verdict="DIFFERS: $(paste -d' ' "$folder/$name.old" "$folder/$name.new" | awk 'NF==6 { d = $3 - $6; if (d < 0) d = -d; if (d > m) m = d } END { printf "largest change %.2g", m }')"
  fi
  printf '%-14s %8d lines  %s\n' "$name" "$lines" "$verdict"
  rm -f "$folder/$name".*
done < <(cases)
exit $differ
