# The map of loads as a table in Markdown: M along the rows, L along the columns, for each wedge.
#   awk -f postprocess/stability_table.awk stability_map.csv
# A cell contains the convergence factor and the work units on the finest grid; then s: a later start, c:
# load continuation, N: Newton.
# A star means that the estimated error of Hm exceeds 10 %: the grid is too coarse for the contact.
# Cases that did not converge, were refused or failed are given in words and never as numbers.
function letter(path) {
  if (path ~ /^newton/) return " N"
  if (path == "load-continuation") return " c"
  return path == "full-multigrid" ? "" : " s"
}
function cell() {
  if ($at["status"] != "converged") return $at["status"]
  factor = $at["cycle_factor"] == "NaN" ? "–" : sprintf("%.2f", $at["cycle_factor"])
  star = $at["error_Hm"] != "NaN" && $at["error_Hm"] > 0.1 ? "*" : ""
  return factor ", " sprintf("%.0f", $at["work_units"]) letter($at["path"]) star
}
BEGIN { FS = "," }
/^# set: / { settings = settings (settings == "" ? "" : ", ") substr($0, 8) }
/^#/ { next }
!("status" in at) {
  for (k = 1; k <= NF; ++k) at[$k] = k
  if (!("contact.M" in at) || !("contact.L" in at)) {
    print "stability_table.awk: no table of `ehl sweep` that varies contact.M and contact.L" > "/dev/stderr"
    exit failed = 1
  }
  next
}
{
  M = $at["contact.M"]; L = $at["contact.L"]; wedge = ("discretization.wedge" in at) ? $at["discretization.wedge"] : ""
  if (!(M in seen_M)) { seen_M[M] = 1; Ms[++count_M] = M }
  if (!(L in seen_L)) { seen_L[L] = 1; Ls[++count_L] = L }
  if (!(wedge in seen_wedge)) { seen_wedge[wedge] = 1; wedges[++count_wedge] = wedge }
  cells[wedge, M, L] = cell()
}
END {
  if (failed) exit 1
  for (w = 1; w <= count_wedge; ++w) {
    if (wedges[w] != "") printf "%s%s:\n\n", wedges[w], settings == "" ? "" : ", " settings
    line = "| M \\ L |"; rule = "|---|"
    for (l = 1; l <= count_L; ++l) { line = line " " Ls[l] " |"; rule = rule "---|" }
    print line "\n" rule
    for (m = 1; m <= count_M; ++m) {
      line = "| " Ms[m] " |"
      for (l = 1; l <= count_L; ++l) line = line " " cells[wedges[w], Ms[m], Ls[l]] " |"
      print line
    }
    print ""
  }
}
