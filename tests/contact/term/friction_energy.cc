// SPDX-License-Identifier: LGPL-2.1-or-later
// What the interface takes from the bodies is stored in it, lost when surfaces
// meet or rubbed away, to round-off on a plane master.
#include "two_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;
using dealii::Tensor;

namespace
{
  using Values = TwoSurfaces::Values;

  constexpr double c_N = 200., c_T = 50., mu = .3;

  InterfaceDescription rubbing()
  {
    InterfaceDescription description;
    description.penalty          = c_N;
    description.friction         = mu;
    description.friction_penalty = c_T;
    return description;
  }

  /// A plate on a wide floor, both plane; faces meet at z = 0.
  TwoSurfaces plate_on_floor(const unsigned int dim, const MasterKind kind)
  {
    const HeightOf plane = [](double, double) { return 0.; };
    return TwoSurfaces({dim, 2, -1., 1., plane, false},
                       {dim, 1, -5., 5., plane, true},
                       kind,
                       rubbing());
  }

  /// Goes to a place @p along and @p above the floor [mm].
  Values place(const TwoSurfaces &pair, const double along, const double above)
  {
    Tensor<1, 3> shift;
    shift[0]            = along;
    shift[pair.dim - 1] = above;
    return pair.shifted_slave(shift);
  }

  /// Trapezoidal work [mJ] of the forces on all nodes over one increment.
  double accept_and_measure(TwoSurfaces &pair, const Values &to)
  {
    const Values old   = pair.accepted;
    const auto   R_old = pair.evaluate(old).R;
    const auto   R     = pair.evaluate(to).R;
    pair.accept(to);
    double work = 0.;
    for (unsigned int i = 0; i < pair.n; ++i)
      work += .5 * (R_old(i) + R(i)) * (to[i] - old[i]);
    return work;
  }

  constexpr MasterKind both_kinds[] = {MasterKind::rigid,
                                       MasterKind::deformable};
} // namespace

TEST(FrictionEnergy, of_sliding_under_growing_pressure_is_that_of_coulomb)
{
  // W = integral of mu p(t) v dt A, of which t^2/2/c_T A stays in the penalty.
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      for (const unsigned int n : {1u, 3u})
        {
          SCOPED_TRACE(std::to_string(dim) +
                       "-D, increments: " + std::to_string(n));
          TwoSurfaces  pair = plate_on_floor(dim, kind);
          const double area = dim == 2 ? 2. : 4., slide = .5;
          const double gap_0 = -.01, gap_1 = -.04, start = .2;
          pair.accept(place(pair, 0., gap_0));
          pair.accept(place(pair, .5 * start, gap_0));
          pair.accept(place(pair, start, gap_0)); // slides
          const double before = pair.term->energies().friction;
          for (unsigned int k = 1; k <= n; ++k)
            {
              const double share = static_cast<double>(k) / n;
              pair.accept(place(pair,
                                start + share * slide,
                                gap_0 + share * (gap_1 - gap_0)));
            }
          const double L_0 = -mu * c_N * gap_0, L_1 = -mu * c_N * gap_1;
          const double work   = .5 * (L_0 + L_1) * slide * area;
          const double stored = .5 * (L_1 * L_1 - L_0 * L_0) / c_T * area;
          EXPECT_NEAR(pair.term->energies().friction - before,
                      work - stored,
                      1e-10 * work);
        }
}

TEST(FrictionEnergy, closes_the_balance_of_increments_that_stick_or_slide)
{
  // The trapezoidal work is exact where the traction is linear over the
  // increment: not where a point that stuck starts to slide in its midst.
  struct Move
  {
    double along, above;
    bool   starts_to_slide = false;
  };
  // Closes, sticks, slides, turns round, slides back, lets go, comes again.
  const Move path[] = {{0., -.01},
                       {.01, -.02},
                       {.1, -.03, true},
                       {.15, -.02},
                       {.14, -.02},
                       {-.1, -.03, true},
                       {-.2, -.01},
                       {-.201, .02},
                       {0., .05},
                       {.1, -.02},
                       {.11, -.02},
                       {.112, .01}};
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      {
        SCOPED_TRACE(std::to_string(dim) + "-D");
        TwoSurfaces  pair = plate_on_floor(dim, kind);
        const double area = dim == 2 ? 2. : 4.;
        double       gap = 0., friction = 0.;
        for (const Move &move : path)
          {
            SCOPED_TRACE("to " + std::to_string(move.along));
            const double work =
              accept_and_measure(pair, place(pair, move.along, move.above));
            const Energies e = pair.term->energies();
            EXPECT_GE(e.friction, friction);
            friction           = e.friction;
            const double total = e.stored + e.friction + e.impact;
            if (move.starts_to_slide)
              {
                // The rule misses at most the limit along what c_T allows.
                const double most = mu * c_N * .03;
                EXPECT_GT(total - gap, work);
                EXPECT_LT(total - gap - work, most * .25 * area);
              }
            else
              EXPECT_NEAR(total - gap, work, 1e-12);
            gap = total;
          }
        EXPECT_GT(friction, .1);
      }
}
