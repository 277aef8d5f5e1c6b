// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of the node-to-segment term is the derivative of its residual,
// for every kind of pairing and every state of friction and bond.
#include "two_surfaces.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

using namespace demold;
using dealii::Tensor;

namespace
{
  using Values = TwoSurfaces::Values;

  constexpr double tolerance = 1e-6;

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  /// Where slave points press on the master.
  struct Place
  {
    std::string  name;
    Grid         slave, master;
    unsigned int closed;       ///< points under pressure; a node at a tip of
                               ///< the slave is one point per smooth patch
    unsigned int master_nodes; ///< that carry them
    Tensor<1, 3> slide;        ///< unit length, stays on face, edge or vertex
    double       noise;        ///< [mm]
  };

  /// Valleys and pits: below them, a node has no foot on any face. Points begin
  /// 0.1 mm above the master and go down by 0.2 mm, as only what comes through
  /// the gap touches.
  std::vector<Place> places()
  {
    const HeightOf slope  = [](double x, double y) { return .1 * x + .05 * y; };
    const HeightOf valley = [](double x, double) { return .5 * std::abs(x); };
    const HeightOf pit    = [](double x, double y) {
      return .5 * (std::abs(x) + std::abs(y));
    };
    const auto above = [](const HeightOf &z) {
      return [z](double x, double y) { return z(x, y) + .1; };
    };
    const HeightOf into_valley = [valley](double x, double y) {
      return std::abs(x) < .1 && std::abs(y) > .1 ? .1 : valley(x, y) + .25;
    };
    const HeightOf into_pit = [pit](double x, double y) {
      return std::abs(x) + std::abs(y) < .1 ? .1 : pit(x, y) + .25;
    };
    const Tensor<1, 3> e_x = vector(1., 0., 0.), e_y = vector(0., 1., 0.);
    return {{"line",
             {2, 3, -1.5, 1.3, above(slope), false},
             {2, 2, -2., 2., slope, true},
             4,
             3,
             e_x,
             .02},
            {"node of a line",
             {2, 2, -1., 1., into_pit, false},
             {2, 2, -2., 2., pit, true},
             2,
             1,
             e_x,
             .01},
            {"face",
             {3, 3, -1.5, 1.3, above(slope), false},
             {3, 2, -2., 2., slope, true},
             16,
             9,
             .6 * e_x + .8 * e_y,
             .02},
            {"edge",
             {3, 2, -1., 1., into_valley, false},
             {3, 2, -2., 2., valley, true},
             4,
             3,
             e_y,
             .01},
            {"vertex",
             {3, 2, -1., 1., into_pit, false},
             {3, 2, -2., 2., pit, true},
             4,
             1,
             .6 * e_x + .8 * e_y,
             .01}};
  }

  InterfaceDescription pressed(const double friction)
  {
    InterfaceDescription description;
    description.penalty          = 200.;
    description.friction         = friction;
    description.friction_penalty = 500.;
    return description;
  }

  Values pressed_down(const TwoSurfaces &pair)
  {
    return pair.shifted_slave(pair.dim == 2 ? vector(0., -.2, 0.) :
                                              vector(0., 0., -.2));
  }

  Values sum(Values a, const Values &b)
  {
    for (unsigned int i = 0; i < a.size(); ++i)
      a[i] += b[i];
    return a;
  }

  /// Number of master nodes with a force.
  unsigned int loaded_master_nodes(TwoSurfaces &pair, const Values &at)
  {
    const auto   R = pair.evaluate(at).R;
    unsigned int n = 0;
    for (const auto &node : pair.master.nodes)
      {
        double force = 0.;
        for (unsigned int d = 0; d < pair.dim; ++d)
          force += std::abs(R(node.unknowns[d]));
        n += force > 0. ? 1 : 0;
      }
    return n;
  }

  constexpr MasterKind both_kinds[] = {MasterKind::rigid,
                                       MasterKind::deformable};

  std::string text(const MasterKind kind)
  {
    return kind == MasterKind::rigid ? "rigid" : "deformable";
  }
} // namespace

TEST(InterfaceTangent, of_pressure_matches_differences_at_faces_edges_vertices)
{
  for (const Place &place : places())
    for (const MasterKind kind : both_kinds)
      {
        SCOPED_TRACE(place.name + ", " + text(kind));
        TwoSurfaces  pair(place.slave, place.master, kind, pressed(0.));
        const Values at = pair.with_noise(pressed_down(pair), place.noise, 1);
        EXPECT_LT(pair.tangent_error(at), tolerance);
        EXPECT_EQ(pair.count(4), place.closed);
        if (kind == MasterKind::deformable)
          {
            EXPECT_EQ(loaded_master_nodes(pair, at), place.master_nodes);
          }
      }
}

TEST(InterfaceTangent, of_friction_matches_differences_at_faces_and_edges)
{
  for (const Place &place : places())
    for (const MasterKind kind : both_kinds)
      {
        if (place.master_nodes == 1) // stick point and foot are the same node
          continue;
        SCOPED_TRACE(place.name + ", " + text(kind));
        TwoSurfaces  pair(place.slave, place.master, kind, pressed(.1));
        const Values base = pair.with_noise(pressed_down(pair), place.noise, 2);
        pair.accept(base); // stick points are set where it closes

        // 0.5 MPa of stick below a limit of about 2 MPa
        const Values stuck =
          pair.with_noise(sum(base, pair.shifted_slave(.001 * place.slide)),
                          2e-4,
                          3);
        EXPECT_LT(pair.tangent_error(stuck), tolerance);
        EXPECT_EQ(pair.count(4), place.closed);

        // 5 MPa if it did not slip
        const Values slipped =
          pair.with_noise(sum(base, pair.shifted_slave(.01 * place.slide)),
                          2e-4,
                          4);
        EXPECT_LT(pair.tangent_error(slipped), tolerance);
        EXPECT_EQ(pair.count(5), place.closed);

        // the stick point has been dragged off the closest point
        pair.accept(slipped);
        const Values back =
          sum(slipped, pair.shifted_slave(-.002 * place.slide));
        EXPECT_LT(pair.tangent_error(back), tolerance);
        EXPECT_EQ(pair.count(4), place.closed);
        const Values on = sum(slipped, pair.shifted_slave(.008 * place.slide));
        EXPECT_LT(pair.tangent_error(on), tolerance);
        EXPECT_EQ(pair.count(5), place.closed);
      }
}

TEST(InterfaceTangent, of_friction_matches_differences_after_sliding_into_a_pit)
{
  for (const Place &place : places())
    for (const MasterKind kind : both_kinds)
      for (const double friction : {.1, 100.})
        {
          if (place.master_nodes != 1)
            continue;
          SCOPED_TRACE(place.name + ", " + text(kind));
          TwoSurfaces  pair(place.slave, place.master, kind, pressed(friction));
          const Values in_pit =
            pair.with_noise(pressed_down(pair), place.noise, 2);
          pair.accept(sum(in_pit, pair.shifted_slave(.12 * place.slide)));
          EXPECT_LT(pair.tangent_error(in_pit), tolerance);
          // 60 MPa if it did not slip, limit 2 MPa or 2000 MPa
          EXPECT_EQ(pair.count(friction < 1. ? 5 : 4), place.closed);
        }
}

TEST(InterfaceTangent, stays_exact_when_a_point_slips_onto_another_face)
{
  for (const unsigned int dim : {2u, 3u})
    {
      SCOPED_TRACE(dim);
      const HeightOf hill = [](double x, double y) {
        return -.02 * (x * x + y * y);
      };
      // One row of nodes starts at x = -0.1 and ends at x = 0.15, on the next
      // facet; the stick points stay behind.
      TwoSurfaces  pair({dim,
                         3,
                         -.1,
                         1.4,
                         [&](double x, double y) { return hill(x, y) - .06; },
                         false},
                       {dim, 4, -2., 2., hill, true},
                       MasterKind::deformable,
                       pressed(.1));
      const Values base = pair.with_noise(Values(pair.n, 0.), .01, 5);
      pair.accept(base);
      const Values over =
        sum(base, pair.shifted_slave(vector(.25, dim == 3 ? .22 : 0., 0.)));
      EXPECT_LT(pair.tangent_error(over), tolerance);
      EXPECT_EQ(pair.count(5), dim == 2 ? 4u : 16u);
    }
}

namespace
{
  struct Mixing
  {
    std::string name;
    ModeMixing  mixing;
    double      coupling;
  };

  const Mixing mixings[] = {{"isotropic", ModeMixing::isotropic, 1.},
                            {"slip limit", ModeMixing::slip_limit, .6},
                            {"energy", ModeMixing::energy, .6},
                            {"proportional", ModeMixing::proportional, .6}};

  /// Peak 0.2 MPa at 0.01 mm, nothing left at 0.1 mm.
  InterfaceDescription bonded(const Mixing           &mixing,
                              const AdhesionUnloading unloading)
  {
    InterfaceDescription description;
    AdhesionLaw          law;
    law.softening        = LinearSoftening{.2, .1, 20.};
    law.factors          = mode_factors(mixing.mixing, mixing.coupling);
    law.unloading        = unloading;
    description.adhesion = law;
    return description;
  }

  /// Two grids that touch: bonds start without a gap.
  TwoSurfaces touching(const unsigned int          dim,
                       const MasterKind            kind,
                       const InterfaceDescription &description,
                       const double                gap = 0.)
  {
    const HeightOf slope = [](double x, double y) { return .1 * x + .05 * y; };
    return TwoSurfaces({dim,
                        3,
                        -1.5,
                        1.3,
                        [=](double x, double y) { return slope(x, y) + gap; },
                        false},
                       {dim, 2, -2., 2., slope, true},
                       kind,
                       description);
  }

  /// Normal of the slope times @p opening plus a slip along it.
  Tensor<1, 3> gap_vector(const unsigned int dim,
                          const double       opening,
                          const double       slip)
  {
    const Tensor<1, 3> n = dim == 2 ? vector(-.1, 1., 0.) / std::sqrt(1.01) :
                                      vector(-.1, -.05, 1.) / std::sqrt(1.0125);
    const Tensor<1, 3> t = dim == 2 ? vector(1., .1, 0.) / std::sqrt(1.01) :
                                      vector(1., 0., .1) / std::sqrt(1.01);
    return opening * n + slip * t;
  }

  /// Checks the tangent of a bond that adheres, softens, and unloads, first
  /// while it opens, then under pressure, where shear alone counts.
  void check_bond(const unsigned int          dim,
                  const MasterKind            kind,
                  const InterfaceDescription &description)
  {
    const unsigned int n_points = dim == 2 ? 4 : 16;
    // Unloading sticks to the elastic branch for small steps back.
    for (const double opening : {1., -.2})
      {
        SCOPED_TRACE("opening " + std::to_string(opening));
        TwoSurfaces pair = touching(dim, kind, description);
        const auto  at   = [&](const double size, const int seed) {
          return pair.with_noise(pair.shifted_slave(
                                   gap_vector(dim, opening * size, .8 * size)),
                                 .05 * size,
                                 seed);
        };
        EXPECT_LT(pair.tangent_error(at(.003, 6)), tolerance);
        EXPECT_EQ(pair.count(0), n_points);
        EXPECT_LT(pair.tangent_error(at(.04, 7)), tolerance);
        EXPECT_EQ(pair.count(1), n_points);
        pair.accept(at(.04, 7));
        EXPECT_LT(pair.tangent_error(at(.05, 8)), tolerance);
        EXPECT_EQ(pair.count(1), n_points);
        EXPECT_LT(pair.tangent_error(at(.0385, 7)), tolerance);
        EXPECT_EQ(pair.count(2), n_points);
      }
  }
} // namespace

TEST(InterfaceTangent, of_a_bond_matches_differences_in_all_four_mixings)
{
  for (const Mixing &mixing : mixings)
    for (const unsigned int dim : {2u, 3u})
      for (const MasterKind kind : both_kinds)
        {
          SCOPED_TRACE(mixing.name + ", " + std::to_string(dim) + "-D, " +
                       text(kind));
          check_bond(dim, kind, bonded(mixing, AdhesionUnloading::damage));
        }
}

TEST(InterfaceTangent, of_a_bond_that_unloads_plastically_matches_differences)
{
  for (const Mixing &mixing : mixings)
    for (const unsigned int dim : {2u, 3u})
      for (const MasterKind kind : both_kinds)
        {
          SCOPED_TRACE(mixing.name + ", " + std::to_string(dim) + "-D, " +
                       text(kind));
          check_bond(dim, kind, bonded(mixing, AdhesionUnloading::plastic));
        }
}

TEST(InterfaceTangent, of_a_bond_that_began_with_a_gap_matches_differences)
{
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      {
        SCOPED_TRACE(std::to_string(dim) + "-D, " + text(kind));
        TwoSurfaces pair =
          touching(dim,
                   kind,
                   bonded(mixings[2], AdhesionUnloading::damage),
                   .03);
        const Values at =
          pair.with_noise(pair.shifted_slave(gap_vector(dim, .03, .02)),
                          .002,
                          9);
        EXPECT_LT(pair.tangent_error(at), tolerance);
        EXPECT_EQ(pair.count(1), dim == 2 ? 4u : 16u);
      }
}

TEST(InterfaceTangent, of_bond_and_friction_together_matches_differences)
{
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      for (const double slip : {.02, .05})
        {
          SCOPED_TRACE(std::to_string(dim) + "-D, " + text(kind));
          InterfaceDescription description =
            bonded(mixings[2], AdhesionUnloading::damage);
          description.friction         = .3;
          description.friction_penalty = 50.;
          TwoSurfaces pair             = touching(dim, kind, description);
          pair.accept(
            pair.with_noise(pair.shifted_slave(gap_vector(dim, -.02, 0.)),
                            .002,
                            10));
          // 1 MPa below, 2.5 MPa above the limit of 1.2 MPa
          const Values at =
            pair.with_noise(pair.shifted_slave(gap_vector(dim, -.02, slip)),
                            .002,
                            11);
          EXPECT_LT(pair.tangent_error(at), tolerance);
        }
}

namespace
{
  /// What the weak form gets from the term.
  struct SystemAnswer
  {
    SparseMatrix matrix;
    Vector       residual;
  };

  SystemAnswer system_answer(TwoSurfaces       &pair,
                             const Values      &at,
                             const unsigned int iteration = 0)
  {
    dealii::AffineConstraints<double> none;
    none.close();
    SystemAnswer result;
    result.residual.reinit(pair.u.locally_owned_elements(), MPI_COMM_SELF);
    Vector          unused(result.residual);
    SystemAssembler system(none,
                           result.residual,
                           unused,
                           &result.matrix,
                           false);
    pair.evaluate(at, system, iteration, [&] {
      dealii::DynamicSparsityPattern pattern(pair.n);
      pair.term->add_couplings(pattern, none);
      result.matrix.reinit(pattern);
    });
    result.residual.compress(dealii::VectorOperation::add);
    result.matrix.compress(dealii::VectorOperation::add);
    return result;
  }
} // namespace

TEST(InterfaceTangent, arrives_unchanged_in_the_matrix_of_the_system)
{
  InterfaceDescription description =
    bonded(mixings[2], AdhesionUnloading::damage);
  description.friction         = .3;
  description.friction_penalty = 50.;
  TwoSurfaces pair = touching(3, MasterKind::deformable, description);
  pair.accept(pair.shifted_slave(gap_vector(3, -.02, 0.)));
  // Slip: a master node may carry foot, stick point and bond at once.
  const Values at =
    pair.with_noise(pair.shifted_slave(gap_vector(3, -.02, .05)), .002, 12);
  const DenseAssembler dense = pair.evaluate(at);

  const SystemAnswer system  = system_answer(pair, at);
  const double       largest = dense.K.linfty_norm();
  for (unsigned int i = 0; i < pair.n; ++i)
    {
      EXPECT_NEAR(system.residual(i), dense.R(i), 1e-13);
      for (unsigned int j = 0; j < pair.n; ++j)
        EXPECT_NEAR(system.matrix.el(i, j), dense.K(i, j), 1e-13 * largest);
    }
}

TEST(InterfaceTangent,
     fits_the_matrix_when_a_kept_pairing_leaves_the_candidates)
{
  // Newton keeps pairings after some iterations; a node may then be thrown so
  // far that a new search does not find its facet any more.
  InterfaceDescription description = pressed(0.);
  description.search_distance      = .1;
  description.skin                 = .1;
  const HeightOf flat              = [](double, double) { return 0.; };
  const HeightOf low               = [](double, double) { return -.05; };
  TwoSurfaces    pair({3, 2, -.7, .9, low, false},
                   {3, 8, -2., 2., flat, true},
                   MasterKind::deformable,
                   description);
  const Values   start(pair.n, 0.);
  system_answer(pair, start, 8);
  ASSERT_EQ(pair.count(4), 9u);
  EXPECT_NO_THROW(
    system_answer(pair, pair.shifted_slave(vector(1., 0., 0.)), 9));
}
