#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Error over CPU time of three scenes: writes accuracy.csv and accuracy.svg.
#
# Usage: accuracy.sh EXECUTABLE [FOLDER]
#   EXECUTABLE  build/step-nts-adhesion/step-nts-adhesion
#   FOLDER      for the table and the picture; default: plots/ beside this file
#
# What the error is [-]:
#   pull-off, cells       largest deviation of the force from the closed form of
#                         rubber and bond in series, over the peak strength*area
#   pull-off, increment   deviation of the largest force seen, over that peak
#   pull-off, penalty     mean deviation of the force from the curve of a rigid
#                         bond (infinite penalty): area between both over G_c A
#   hertz, all            the larger one of the errors of half-width and peak
#                         pressure (Johnson 1985); both from a least-squares fit
#                         of p^2 = p_0^2 (1 - x^2/a^2) to the closed points
#   block, all            deviation of the reaction from the limit of q1p0 with
#                         6, 12, 24 elements per edge (Aitken extrapolation)
# CPU time is that of summary.json: without start-up and reading of libraries.
set -eu
LC_ALL=C
export LC_ALL
if [ $# -lt 1 ]; then
  echo "Usage: accuracy.sh EXECUTABLE [FOLDER]" >&2
  exit 2
fi
step=$1
here=$(dirname -- "$(readlink -f -- "$0")")
plots=${2:-$here/plots}
scenes=$here/../prm/step-nts-adhesion
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"
table=$plots/accuracy.csv
mkdir -p "$plots"
echo 'scene,what is varied,value,unknowns,error [-],cpu time [s]' > "$table"

# run SCENE "section/entry=value"...: leaves its output in $scratch/out
run()
{
  scene=$1
  shift
  rm -rf "$scratch/out"
  for entry in "$@"; do
    set -- "$@" --set "$entry"
    shift
  done
  "$step" "$scenes/$scene.prm" --output "$scratch/out" --quiet \
    --set "Output/fields every=0" "$@" > "$scratch/log" 2>&1 || {
    cat "$scratch/log" >&2
    exit 1
  }
}

# number NAME: an entry of summary.json
number()
{
  awk -v name="\"$1\":" 'index($0, name) { sub(/.*: /, ""); sub(/,$/, ""); print }' \
    "$scratch/out/summary.json"
}

# row SCENE VARIED VALUE ERROR
row()
{
  echo "$1,$2,$3,$(number 'degrees of freedom'),$4,$(number 'cpu time [s]')" |
    tee -a "$table"
}

# Confined column of 8 mm (theory A1) and bilinear bond (theory C.2). With
# measure=largest: against the bond as it is; otherwise against a rigid one.
pull_off_error()
{
  awk -F, -v measure="$1" -v penalty="$2" '
    function confined(l,   I1, S) {
      I1 = l * l + 2
      S = .4 + .1 * (I1 - l * l) + (25 * (l * l - 1) - .6) / (l * l)
      return l * S
    }
    function stretch(P,   a, b, i, m) {
      a = .5; b = 2
      for (i = 0; i < 60; ++i) {
        m = (a + b) / 2
        if (confined(m) > P) b = m; else a = m
      }
      return m
    }
    function bond(g) {
      if (g <= onset) return onset > 0 ? .2 * g / onset : .2
      return g >= .1 ? 0 : .2 * (.1 - g) / (.1 - onset)
    }
    function opening(g) { return g + 8 * (stretch(bond(g)) - 1) }
    function force(u,   a, b, i, m) {
      if (u >= .1) return 0
      if (u <= opening(onset) && onset == 0) return 2 * confined(1 + u / 8)
      a = 0; b = .1
      for (i = 0; i < 60; ++i) {
        m = (a + b) / 2
        if (opening(m) > u) b = m; else a = m
      }
      return 2 * bond(m)
    }
    function abs(x) { return x < 0 ? -x : x }
    BEGIN { onset = measure == "largest" ? .2 / penalty : 0 }
    NR > 1 {
      e = abs($3 - force($2))
      if (e > worst) worst = e
      area += (e + e_old) / 2 * ($2 - u_old)
      e_old = e; u_old = $2
    }
    END { printf "%.3e\n", measure == "largest" ? worst / .4 : area / .02 }
  ' "$scratch/out/history.csv"
}

hertz_error()
{
  awk -F, '
    function abs(x) { return x < 0 ? -x : x }
    NR > 1 && $6 > 0 {
      x = $1 * $1; y = $6 * $6
      n += 1; X += x; Y += y; XX += x * x; XY += x * y
    }
    END {
      pi = atan2(0, -1)
      lambda = 48.926 + 2 * .20134; G = .80537 + .20134
      nu = lambda / (lambda + G) / 2
      E = 2 * G * (1 + nu) / (1 - nu * nu)
      a = sqrt(4 * .1 * 10 / (pi * E)); p = 2 * .1 / (pi * a)
      slope = (n * XY - X * Y) / (n * XX - X * X)
      peak2 = (Y - slope * X) / n
      ea = abs(sqrt(-peak2 / slope) / a - 1); ep = abs(sqrt(peak2) / p - 1)
      printf "%.3e\n", (ea > ep ? ea : ep)
    }' "$scratch/out/interface.csv"
}

for cells in 1 2 4 8 16; do
  run pull-off "Body/cells=$cells, $((4 * cells))"
  row pull-off cells $((4 * cells)) "$(pull_off_error largest 20)"
done
for increment in 0.008 0.004 0.002 0.001 0.0005; do
  run pull-off "Solution/largest increment=$increment"
  row pull-off increment $increment \
    "$(number 'peak force [N]' | awk '{printf "%.3e\n", 1 - $1 / .4}')"
done
for penalty in 10 20 50 100 200 1000; do
  run pull-off "Adhesion/penalty=$penalty" "Solution/largest increment=0.0005"
  row pull-off penalty $penalty "$(pull_off_error area $penalty)"
done

for size in 0.2 0.1 0.05 0.025; do
  run hertz "Body/fine size=$size"
  row hertz "fine size" $size "$(hertz_error)"
done
for penalty in 20 50 100 200 500 1000; do
  run hertz "Contact/penalty=$penalty"
  row hertz penalty $penalty "$(hertz_error)"
done

# The limit is known only after the runs: keep the forces first.
: > "$scratch/forces"
for case in q1:4 q1:6 q1:12 q1:24 q1p0:4 q1p0:6 q1p0:12 q1p0:24 q2:2 q2:3 q2:6 q2:10; do
  element=${case%:*}
  n=${case#*:}
  run block "element=$element" "Body/cells=$n, $n, $n"
  echo "$element $n $(number 'degrees of freedom') $(number 'peak force [N]')" \
    "$(number 'cpu time [s]')" >> "$scratch/forces"
done
awk '
  { f[$1, $2] = $4; line[NR] = $0 }
  END {
    a = f["q1p0", 6]; b = f["q1p0", 12]; c = f["q1p0", 24]
    limit = c - (c - b) ^ 2 / (c - 2 * b + a)
    print "# limit of the reaction [N]: " limit > "/dev/stderr"
    for (i = 1; i <= NR; ++i) {
      split(line[i], w, " ")
      e = w[4] / limit - 1
      printf "block,%s,%s,%s,%.3e,%s\n", w[1], w[2], w[3], e < 0 ? -e : e, w[5]
    }
  }' "$scratch/forces" | tee -a "$table"

command -v gnuplot > /dev/null || exit 0
cd "$plots"
gnuplot << 'END'
set terminal svg size 800,560 noenhanced font 'sans,14' background 'white'
set output 'accuracy.svg'
set title "Error over CPU time"
set grid linecolor rgb '#d0d0d0'
set border linecolor rgb '#404040'
set datafile separator comma
set logscale xy
set format y '%.0e'
set xlabel "CPU time [s]"
set ylabel "error [-]"
set key outside right
c(s, w) = sprintf("< awk -F, '$1 == \"%s\" && $2 == \"%s\"' accuracy.csv", s, w)
plot c("pull-off", "increment") using 6:5 with linespoints lw 2 pt 7 lc rgb '#0072b2' title "pull-off, increment", \
  c("pull-off", "penalty") using 6:5 with linespoints lw 2 pt 7 lc rgb '#56b4e9' title "pull-off, penalty", \
  c("hertz", "fine size") using 6:5 with linespoints lw 2 pt 5 lc rgb '#009e73' title "hertz, fine size", \
  c("hertz", "penalty") using 6:5 with linespoints lw 2 pt 5 lc rgb '#8c6d1f' title "hertz, penalty", \
  c("block", "q1") using 6:5 with linespoints lw 2 pt 9 lc rgb '#cc79a7' title "block, q1", \
  c("block", "q1p0") using 6:5 with linespoints lw 2 pt 9 lc rgb '#d55e00' title "block, q1p0", \
  c("block", "q2") using 6:5 with linespoints lw 2 pt 9 lc rgb '#e69f00' title "block, q2"
END
