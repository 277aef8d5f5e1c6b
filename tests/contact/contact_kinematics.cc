// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of gap, normal, contact and friction force match differences.
#include "contact/contact_kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
  using namespace demold;
  using dealii::Point;
  using dealii::Tensor;

  /// A slave node, a master surface and a stick point on a facet of its own.
  struct Pair
  {
    ContactPoint          point;
    Point<3>              x_s;
    ContactSurface        surface;
    FrictionAnchor        anchor;
    std::vector<Point<3>> anchor_nodes;

    ContactKinematics kinematics() const
    {
      return contact_kinematics(*project_again(point, x_s, surface),
                                x_s,
                                surface);
    }

    unsigned int n_dofs() const
    {
      return 3 * (1 + point.n_nodes + anchor.n_nodes);
    }

    /// The same pair with entry @p j of q moved by @p h.
    Pair moved(const unsigned int j, const double h) const
    {
      Pair               result = *this;
      const unsigned int b = j / 3, c = j % 3;
      if (b == 0)
        result.x_s[c] += h;
      else if (b <= point.n_nodes)
        {
          auto x = surface.positions();
          x[point.nodes[b - 1]][c] += h;
          result.surface.set_positions(x);
        }
      else
        result.anchor_nodes[b - 1 - point.n_nodes][c] += h;
      result.place_anchor();
      return result;
    }

    void place_anchor()
    {
      anchor.x = Point<3>();
      for (unsigned int i = 0; i < anchor.n_nodes; ++i)
        anchor.x += anchor.N[i] * Tensor<1, 3>(anchor_nodes[i]);
    }
  };

  struct Random
  {
    std::mt19937 engine{20140711};

    double operator()(const double size)
    {
      return std::uniform_real_distribution<double>(-size, size)(engine);
    }

    Point<3> point(const double size, const bool in_plane)
    {
      const double x = (*this)(size), y = (*this)(size), z = (*this)(size);
      return Point<3>(x, y, in_plane ? 0. : z);
    }
  };

  /// Two by two warped faces about a peaked (or dented) vertex, number 4.
  ContactSurface warped_faces(Random &random, const double peak)
  {
    std::vector<Point<3>> x;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 3; ++i)
        x.push_back(Point<3>(i, j, i == 1 && j == 1 ? peak : 0.) +
                    Tensor<1, 3>(random.point(0.15, false)));
    return ContactSurface({{{{0, 1, 4, 3}}, 4},
                           {{{1, 2, 5, 4}}, 4},
                           {{{3, 4, 7, 6}}, 4},
                           {{{4, 5, 8, 7}}, 4}},
                          x);
  }

  /// Two lines about a peaked (or dented) node, number 1, body below.
  ContactSurface bent_lines(Random &random, const double peak)
  {
    std::vector<Point<3>> x;
    for (unsigned int i = 0; i < 3; ++i)
      x.push_back(Point<3>(i, i == 1 ? peak : 0., 0.) +
                  Tensor<1, 3>(random.point(0.15, true)));
    return ContactSurface({{{{1, 0, 0, 0}}, 2}, {{{2, 1, 0, 0}}, 2}}, x);
  }

  void
  add_anchor(Pair &pair, Random &random, const double size, const double gap)
  {
    const bool in_plane = pair.surface.n_dimensions() == 2;
    const auto kin      = pair.kinematics();
    pair.anchor.n_nodes = in_plane ? 2 : 4;
    const double xi = random(0.9), eta = random(0.9);
    pair.anchor.N        = facet_shape(pair.anchor.n_nodes, {{xi, eta}}).N;
    const Tensor<1, 3> t = random.point(size * std::abs(gap), in_plane);
    for (unsigned int i = 0; i < pair.anchor.n_nodes; ++i)
      pair.anchor_nodes.push_back(kin.x_m + t +
                                  Tensor<1, 3>(random.point(0.3, in_plane)));
    pair.place_anchor();
    const Tensor<1, 3> shift = kin.x_m + t - pair.anchor.x;
    for (auto &node : pair.anchor_nodes)
      node += shift;
    pair.place_anchor();
  }

  /// Penetrating and open pairs of every kind. @p slip [-]: distance of the
  /// stick point over the gap.
  std::vector<Pair> pairs(const double slip)
  {
    Random            random;
    std::vector<Pair> result;
    const auto        add = [&](const ContactSurface &surface,
                         const ContactPoint   &at,
                         const Point<3>       &foot,
                         const Tensor<1, 3>   &offset) {
      Pair pair{at, foot + offset, surface, {}, {}};
      pair.point = *project_again(at, pair.x_s, surface);
      add_anchor(pair, random, slip, pair.point.gap);
      result.push_back(pair);
    };
    for (unsigned int k = 0; k < 5; ++k)
      for (const bool in_plane : {false, true})
        for (const double sign : {-1., 1.})
          {
            const auto   surface = in_plane ? bent_lines(random, 0.4 * sign) :
                                              warped_faces(random, 0.4 * sign);
            ContactPoint face{};
            face.kind       = ContactCase::face;
            face.facet      = 1;
            face.n_nodes    = surface.facet(1).n_nodes;
            const double xi = random(0.8), eta = random(0.8);
            const auto   frame =
              facet_frame(surface.facet_positions(1), {{xi, eta}});
            add(surface, face, frame.x, 0.1 * sign * frame.normal);
            result.back().point.nodes = surface.facet(1).nodes;

            ContactPoint vertex{};
            vertex.kind             = ContactCase::vertex;
            const unsigned int node = in_plane ? 1 : 4;
            vertex.nodes[0]         = node;
            const auto normal       = surface.node_normal(node);
            add(surface,
                vertex,
                surface.positions()[node],
                0.1 * sign * normal +
                  Tensor<1, 3>(random.point(0.03, in_plane)));

            if (in_plane)
              continue;
            ContactPoint edge{};
            edge.kind = ContactCase::edge;
            for (edge.edge = 0; !surface.edges()[edge.edge].is_shared();)
              ++edge.edge;
            const auto &nodes = surface.edges()[edge.edge].nodes;
            const auto  a     = surface.positions()[nodes[0]];
            const auto  b     = surface.positions()[nodes[1]];
            add(surface,
                edge,
                a + 0.4 * (b - a),
                0.1 * sign * surface.node_normal(4) +
                  Tensor<1, 3>(random.point(0.03, false)));
          }
    return result;
  }

  using Values = std::function<std::vector<double>(const Pair &)>;

  /// Largest difference between @p derivative (a column per entry of q) and
  /// central differences of @p values, over the largest derivative.
  double derivative_error(const Pair        &pair,
                          const Values      &values,
                          const Values      &derivative,
                          const unsigned int n_dofs)
  {
    const double h        = 1e-5;
    const bool   in_plane = pair.surface.n_dimensions() == 2;
    const auto   exact    = derivative(pair);
    double       error = 0., scale = 0.;
    for (unsigned int j = 0; j < n_dofs; ++j)
      {
        if (in_plane && j % 3 == 2)
          continue;
        const auto plus   = values(pair.moved(j, h));
        const auto minus  = values(pair.moved(j, -h));
        const auto plus2  = values(pair.moved(j, 2. * h));
        const auto minus2 = values(pair.moved(j, -2. * h));
        for (unsigned int i = 0; i < plus.size(); ++i)
          {
            // Fourth order, so that 1e-6 tests the formula.
            const double difference =
              (8. * (plus[i] - minus[i]) - (plus2[i] - minus2[i])) / (12. * h);
            const double value = exact[i * n_dofs + j];
            error              = std::max(error, std::abs(difference - value));
            scale              = std::max(scale, std::abs(value));
          }
      }
    EXPECT_GT(scale, 0.);
    return error / scale;
  }

  template <typename Rows>
  std::vector<double> flat(const Rows        &rows,
                           const unsigned int n_rows,
                           const unsigned int n_dofs)
  {
    std::vector<double> result;
    for (unsigned int i = 0; i < n_rows; ++i)
      result.insert(result.end(), rows[i].begin(), rows[i].begin() + n_dofs);
    return result;
  }

  std::string name(const Pair &pair)
  {
    return std::string(pair.surface.n_dimensions() == 2 ? "2-D " : "3-D ") +
           (pair.point.kind == ContactCase::face ? "face" :
            pair.point.kind == ContactCase::edge ? "edge" :
                                                   "vertex") +
           (pair.point.gap < 0. ? ", closed" : ", open");
  }

  TEST(contact_kinematics, gap_derivative_matches_differences)
  {
    for (const Pair &pair : pairs(0.1))
      EXPECT_LT(derivative_error(
                  pair,
                  [](const Pair &p) {
                    return std::vector<double>{p.kinematics().gap};
                  },
                  [](const Pair &p) {
                    const auto kin = p.kinematics();
                    return std::vector<double>(kin.dgap.begin(),
                                               kin.dgap.begin() + kin.n_dofs());
                  },
                  pair.kinematics().n_dofs()),
                1e-6)
        << name(pair);
  }

  TEST(contact_kinematics, normal_derivative_matches_differences)
  {
    for (const Pair &pair : pairs(0.1))
      EXPECT_LT(derivative_error(
                  pair,
                  [](const Pair &p) {
                    const auto n = p.kinematics().normal;
                    return std::vector<double>{n[0], n[1], n[2]};
                  },
                  [](const Pair &p) {
                    const auto kin = p.kinematics();
                    return flat(kin.dnormal, 3, kin.n_dofs());
                  },
                  pair.kinematics().n_dofs()),
                1e-6)
        << name(pair);
  }

  TEST(contact_kinematics, gap_dnormal_is_gap_times_normal_derivative)
  {
    for (const Pair &pair : pairs(0.1))
      {
        const auto kin = pair.kinematics();
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < kin.n_dofs(); ++j)
            EXPECT_NEAR(kin.gap_dnormal[i][j],
                        kin.gap * kin.dnormal[i][j],
                        1e-14);
      }
  }

  TEST(contact_kinematics, coordinate_derivatives_match_differences)
  {
    for (const Pair &pair : pairs(0.1))
      {
        if (pair.point.kind == ContactCase::vertex)
          continue;
        EXPECT_LT(derivative_error(
                    pair,
                    [](const Pair &p) {
                      const auto xi =
                        project_again(p.point, p.x_s, p.surface)->xi;
                      return std::vector<double>{xi[0], xi[1]};
                    },
                    [](const Pair &p) {
                      const auto kin = p.kinematics();
                      return flat(kin.dxi, 2, kin.n_dofs());
                    },
                    pair.kinematics().n_dofs()),
                  1e-6)
          << name(pair);
      }
  }

  TEST(contact_kinematics, gap_times_normal_joins_closest_point_and_node)
  {
    for (const Pair &pair : pairs(0.1))
      {
        const auto kin = pair.kinematics();
        EXPECT_LT((kin.gap * kin.normal - (kin.x_s - kin.x_m)).norm(), 1e-13)
          << name(pair);
        EXPECT_NEAR(kin.normal.norm(), 1., 1e-14);
      }
  }

  std::vector<double> normal_residual(const Pair &pair)
  {
    std::array<double, 15>                 R;
    std::array<std::array<double, 15>, 15> K;
    const auto                             kin = pair.kinematics();
    normal_contact_force(kin, 50., R, K);
    return std::vector<double>(R.begin(), R.begin() + kin.n_dofs());
  }

  std::vector<double> normal_tangent(const Pair &pair)
  {
    std::array<double, 15>                 R;
    std::array<std::array<double, 15>, 15> K;
    const auto                             kin = pair.kinematics();
    normal_contact_force(kin, 50., R, K);
    return flat(K, kin.n_dofs(), kin.n_dofs());
  }

  TEST(normal_contact_force, is_the_gradient_of_the_penalty_energy)
  {
    for (const Pair &pair : pairs(0.1))
      EXPECT_LT(derivative_error(
                  pair,
                  [](const Pair &p) {
                    const double gap = p.kinematics().gap;
                    return std::vector<double>{0.5 * 50. * gap * gap};
                  },
                  normal_residual,
                  pair.kinematics().n_dofs()),
                1e-6)
        << name(pair);
  }

  TEST(normal_contact_force, tangent_matches_differences)
  {
    for (const Pair &pair : pairs(0.1))
      EXPECT_LT(derivative_error(pair,
                                 normal_residual,
                                 normal_tangent,
                                 pair.kinematics().n_dofs()),
                1e-6)
        << name(pair);
  }

  TEST(normal_contact_force, tangent_is_symmetric)
  {
    for (const Pair &pair : pairs(0.1))
      {
        const auto         K = normal_tangent(pair);
        const unsigned int n = pair.kinematics().n_dofs();
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            EXPECT_NEAR(K[i * n + j], K[j * n + i], 1e-12 * 50.) << name(pair);
      }
  }

  TEST(normal_contact_force, stays_finite_when_a_vertex_is_hit_exactly)
  {
    for (Pair pair : pairs(0.1))
      {
        if (pair.point.kind != ContactCase::vertex)
          continue;
        pair.x_s       = pair.surface.positions()[pair.point.nodes[0]];
        const auto kin = pair.kinematics();
        EXPECT_EQ(kin.gap, 0.);
        EXPECT_NEAR(kin.normal.norm(), 1., 1e-14);
        for (const auto &row : kin.dnormal)
          for (const double entry : row)
            EXPECT_EQ(entry, 0.);
        // A spring that joins two points: stiffness times identity.
        const auto         K  = normal_tangent(pair);
        const unsigned int n  = kin.n_dofs();
        const unsigned int nd = pair.surface.n_dimensions();
        for (unsigned int i = 0; i < nd; ++i)
          for (unsigned int j = 0; j < nd; ++j)
            {
              EXPECT_NEAR(K[i * n + j], i == j ? 50. : 0., 1e-12);
              EXPECT_NEAR(K[i * n + 3 + j], i == j ? -50. : 0., 1e-12);
            }
      }
  }

  constexpr FrictionPenalties penalties{50., 20., 0.3};

  std::vector<double> friction_residual(const Pair &pair)
  {
    const auto F = friction_force(pair.kinematics(), pair.anchor, penalties);
    return std::vector<double>(F.R.begin(), F.R.begin() + F.n_dofs);
  }

  std::vector<double> friction_tangent(const Pair &pair)
  {
    const auto F = friction_force(pair.kinematics(), pair.anchor, penalties);
    return flat(F.K, F.n_dofs, F.n_dofs);
  }

  void check_friction_tangent(const double slip, const FrictionState expected)
  {
    unsigned int n_faces = 0, n_edges = 0, n_vertices = 0;
    for (const Pair &pair : pairs(slip))
      {
        const auto F =
          friction_force(pair.kinematics(), pair.anchor, penalties);
        if (F.state != expected || std::abs(F.trial - F.limit) < 0.02 * F.limit)
          continue;
        n_faces += pair.point.kind == ContactCase::face;
        n_edges += pair.point.kind == ContactCase::edge;
        n_vertices += pair.point.kind == ContactCase::vertex;
        EXPECT_LT(derivative_error(pair,
                                   friction_residual,
                                   friction_tangent,
                                   pair.n_dofs()),
                  1e-6)
          << name(pair);
      }
    EXPECT_GE(n_faces, 6u);
    EXPECT_GE(n_edges, 3u);
    EXPECT_GE(n_vertices, 6u);
  }

  TEST(friction_force, stick_tangent_matches_differences)
  {
    check_friction_tangent(0.5, FrictionState::stick);
  }

  TEST(friction_force, slip_tangent_matches_differences)
  {
    check_friction_tangent(6., FrictionState::slip);
  }
} // namespace
