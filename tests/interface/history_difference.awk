# SPDX-License-Identifier: LGPL-2.1-or-later
# Compares two history.csv: awk -v tolerance=1e-10 -f THIS first second
# Numbers may differ by tolerance times the largest of their column, or of any
# energy for energies, where cancellation counts; all else must be equal.
# Optional: -v skip=PATTERN of columns that are left out.
BEGIN { FS = "," }
function abs(x) { return x < 0 ? -x : x }
FNR == NR {
  rows = FNR
  for (i = 1; i <= NF; i++) a[FNR, i] = $i
  next
}
FNR == 1 {
  columns = NF
  for (i = 1; i <= NF; i++) {
    name[i] = $i
    if ($i != a[1, i]) complain("column " i " is " $i " and " a[1, i])
  }
  next
}
{
  n = FNR
  for (i = 1; i <= columns; i++) {
    if (skip != "" && name[i] ~ skip) continue
    if ($i !~ /^[-+0-9.eE]+$/) {
      if ($i != a[FNR, i]) complain(name[i] " in row " FNR ": " $i ", " a[FNR, i])
      continue
    }
    d = abs($i - a[FNR, i])
    if (d > difference[i]) { difference[i] = d; where[i] = FNR }
    if (abs($i) > largest[i]) largest[i] = abs($i)
    if (name[i] ~ /\[mJ\]/ && abs($i) > energy) energy = abs($i)
  }
}
function complain(text) { if (complaints++ < 10) print text }
END {
  if (n != rows) complain("rows: " rows " and " n)
  for (i = 1; i <= columns; i++) {
    scale = name[i] ~ /\[mJ\]/ ? energy : largest[i]
    if (difference[i] > tolerance * scale)
      complain(name[i] " differs by " difference[i] " of " scale " in row " where[i])
  }
  exit complaints > 0
}
