#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Writes block.prm with N elements per edge as a CalculiX deck to stdout.
#
#   calculix-block.sh 16 > block.inp && OMP_NUM_THREADS=1 ccx block
#
# C3D8R, isochoric Mooney-Rivlin C10 0.3, C01 0.1 MPa, D1 = 2/40 per MPa.
set -eu
awk -v n="${1:-8}" '
  function id(i, j, k) { return 1 + i + (n + 1) * (j + (n + 1) * k) }
  BEGIN {
    print "*NODE, NSET=ALL"
    for (k = 0; k <= n; ++k)
      for (j = 0; j <= n; ++j)
        for (i = 0; i <= n; ++i)
          printf "%d, %.9g, %.9g, %.9g\n", id(i, j, k), 10 * i / n, 10 * j / n, 10 * k / n
    print "*ELEMENT, TYPE=C3D8R, ELSET=BODY"
    for (k = 0; k < n; ++k)
      for (j = 0; j < n; ++j)
        for (i = 0; i < n; ++i)
          printf "%d, %d, %d, %d, %d, %d, %d, %d, %d\n", ++e,
            id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
            id(i, j + 1, k + 1)
    m = (n + 1) * (n + 1)
    printf "*NSET, NSET=BOTTOM, GENERATE\n1, %d\n", m
    printf "*NSET, NSET=TOP, GENERATE\n%d, %d\n", m * n + 1, m * (n + 1)
    print "*MATERIAL, NAME=RUBBER"
    print "*HYPERELASTIC, POLYNOMIAL, N=1\n0.3, 0.1, 0.05"
    print "*SOLID SECTION, ELSET=BODY, MATERIAL=RUBBER"
    print "*BOUNDARY\nBOTTOM, 1, 3\nTOP, 1, 2"
    print "*STEP, NLGEOM, INC=10\n*STATIC, DIRECT\n0.25, 1."
    print "*BOUNDARY\nTOP, 3, 3, -2."
    print "*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n*END STEP"
  }'
