#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The pictures of ../results.md.
#
# Usage: figures.sh BUILD-FOLDER [FOLDER]; default: beside this file. 10 minutes.
set -eu
LC_ALL=C
export LC_ALL
if [ $# -lt 1 ]; then
  echo "Usage: figures.sh BUILD-FOLDER [FOLDER]" >&2
  exit 2
fi
build=$1
here=$(dirname -- "$(readlink -f -- "$0")")
plots=${2:-$here}
prm=$here/../../prm
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT

# run NAME STEP SCENE options...; a run that gives up has a history too
run()
{
  name=$1 step=$2 scene=$3
  shift 3
  "$build/$step/$step" "$prm/$scene" --quiet --output "$runs/$name" "$@" ||
    [ $? = 1 ]
}

for stiffness in 0.5 1.5 5; do
  run spring-$stiffness step-arclength step-arclength/spring.prm \
    --set "Network/springs=bar grip y $stiffness"
done
run truss step-arclength step-arclength/truss-snap-back.prm
for strategy in quasi-static dynamics automatic; do
  run slice-$strategy step-demold step-demold/slice-steep.prm \
    --set "Solution/strategy=$strategy"
done

# Through the same jump by all strategies, and a tread block likewise.
column="--set Material/density=1.1e-9 --set Pull/velocity=0.5"
run column-path step-arclength step-arclength/column.prm
for strategy in dynamics automatic; do
  # shellcheck disable=SC2086
  run column-$strategy step-arclength step-arclength/column.prm $column \
    --set "Solution/strategy=$strategy" --set "Solution/accuracy=0.1"
done
run column-explicit step-arclength step-arclength/column-explicit.prm \
  --set "Pull/opening=0.25"
for strategy in "arc length" dynamics automatic; do
  run "tread-$strategy" step-arclength step-arclength/tread-slice.prm \
    --set "Solution/strategy=$strategy"
done
run tread-explicit step-arclength step-arclength/tread-slice.prm \
  --set "Solution/strategy=explicit dynamics" \
  --set "Solution/largest increment=2e-5" --set "Pull/opening=0.5"

# Thesis 7.2: vary SYMBOL ENTRY VALUES..., others as in step-demold/slice.prm
vary()
{
  symbol=$1 entry=$2
  shift 2
  for value in "$@"; do
    run "$symbol-$value" step-arclength step-arclength/tread-slice.prm \
      --set "Adhesion/strength=0.1" --set "Adhesion/rupture gap=0.2" \
      --set "Adhesion/penalty=40" --set "Solution/strategy=automatic" \
      --set "Adhesion/$entry=$value"
  done
}
vary alpha strength 0.05 0.1 0.2 0.4
vary delta "rupture gap" 0.05 0.1 0.2 0.4
vary gamma penalty 5 20 100 500
vary beta "tangential coupling" 0.25 0.5 1
# At equal G_c of 0.01 mJ/mm^2.
for pair in "0.05 0.4" "0.1 0.2" "0.2 0.1" "0.4 0.05"; do
  alpha=${pair% *} delta=${pair#* }
  run equal-$alpha step-arclength step-arclength/tread-slice.prm \
    --set "Adhesion/strength=$alpha" --set "Adhesion/rupture gap=$delta" \
    --set "Adhesion/penalty=160" --set "Solution/strategy=automatic"
done
# The beam at equal G_c of 0.05 mJ/mm^2: from a cohesive zone far longer than an
# arm is high to one far shorter.
for pair in "0.3 0.166667" "0.6 0.0833333" "1.2 0.0416667" "2.5 0.02" "5 0.01"
do
  alpha=${pair% *} delta=${pair#* }
  run beam-$alpha step-arclength step-arclength/double-cantilever.prm \
    --set "Adhesion/strength=$alpha" --set "Adhesion/rupture gap=$delta" \
    --set "Supports/motion y=4.5*t" --set "Process/opening=4.5*t" \
    --set "Body/fine centre=32.2" --set "Body/fine width=4.6"
done

# A sphere by a load, a grip and along its path.
pull="if(t < 1, -0.0125*t, 0.0225*t - 0.035)"
run jkr step-arclength step-arclength/jkr.prm --set "Body/fine width=0.37" \
  --set "Supports/motion y=$pull" --set "Process/opening=$pull"
run jkr-grip step-arclength step-arclength/jkr-grip.prm
run jkr-load step-arclength step-arclength/jkr-load.prm

gnuplot << END
set datafile separator ","
set key autotitle columnhead
set terminal svg size 640,420 font "sans,12"
set key top right noenhanced
set style data lines

set xlabel "opening [mm]"
set ylabel "force [N]"
set output "$plots/spring-paths.svg"
plot [0:.5] [-.01:.25] for [k in "0.5 1.5 5"] "$runs/spring-".k."/history.csv" \
  using "opening [mm]":"force [N]" title "k_s = ".k." N/mm"

set output "$plots/truss-snap-back.svg"
plot "$runs/truss/history.csv" using "opening [mm]":"force [N]" notitle

set output "$plots/slice-steep-force.svg"
plot [0:.3] for [s in "dynamics automatic quasi-static"] \
  "$runs/slice-".s."/history.csv" using "opening [mm]":"force [N]" title s

set output "$plots/column-strategies.svg"
set key top left
plot [0:.25] [-.15:.45] \
  "$runs/column-path/history.csv" using 2:3 title "arc length" lw 2, \
  for [s in "dynamics explicit automatic"] "$runs/column-".s."/history.csv" \
  using 2:3 title s

set output "$plots/tread-strategies.svg"
set key top right
plot [0:.35] [-10:130] \
  "$runs/tread-arc length/history.csv" using 2:3 title "arc length", \
  for [s in "dynamics automatic explicit"] "$runs/tread-".s."/history.csv" \
  using 2:3 title s

set output "$plots/variation-alpha.svg"
plot [0:.6] for [v in "0.4 0.2 0.1 0.05"] "$runs/alpha-".v."/history.csv" \
  using 2:3 title "alpha = ".v." MPa"
set output "$plots/variation-delta.svg"
plot [0:.6] for [v in "0.4 0.2 0.1 0.05"] "$runs/delta-".v."/history.csv" \
  using 2:3 title "delta = ".v." mm"
set output "$plots/variation-equal-work.svg"
plot [0:.6] for [v in "0.4 0.2 0.1 0.05"] "$runs/equal-".v."/history.csv" \
  using 2:3 title "alpha = ".v." MPa"
set output "$plots/variation-equal-work-beam.svg"
set key bottom right
plot for [v in "5 2.5 1.2 0.6 0.3"] "$runs/beam-".v."/history.csv" \
  using 2:3 title "alpha = ".v." MPa"
set key top right
set output "$plots/variation-gamma.svg"
plot [0:.6] for [v in "5 20 100 500"] "$runs/gamma-".v."/history.csv" \
  using 2:3 title "gamma = ".v." MPa/mm"
set output "$plots/variation-beta.svg"
plot [0:.6] for [v in "1 0.5 0.25"] "$runs/beta-".v."/history.csv" \
  using 2:3 title "beta_T = ".v

# Units of Maugis; w = 4e-4 N/mm, R = 10 mm, K = 4 E*/3.
w = 4e-4; R = 10.; K = 4. / 3. * 3. / (1. - .49**2)
f = pi * w * R
d = (pi**2 * w**2 * R / K**2)**(1. / 3.)
set output "$plots/jkr.svg"
set key bottom right
set xlabel "opening, units of Maugis"
set ylabel "pull over pi w R"
stats "$runs/jkr-load/history.csv" using (column(3) / f) nooutput name "LOAD"
set parametric
set trange [.001:1.3]
plot [.001:1.3] [-.4:1.3] [-.8:1.7] \
  "$runs/jkr/history.csv" using (column(2) / d):(column(3) / f) \
  title "arc length", \
  "$runs/jkr-grip/history.csv" using (column(2) / d):(column(3) / f) \
  title "grip, quasi-static", \
  1.3 * t - .4, LOAD_max title "load, quasi-static: carries no more" dt 2, \
  sqrt(8. * t / 3.) - t * t, sqrt(6. * t**3) - t**3 \
  title "Johnson, Kendall and Roberts" dt 3 lc "black"
END
