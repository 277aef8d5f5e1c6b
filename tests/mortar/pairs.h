// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of faces in every topology, and their derivatives as plain lists.
#ifndef demold_tests_mortar_pairs_h
#define demold_tests_mortar_pairs_h

#include "faces.h"
#include "mortar/auxiliary_plane.h"
#include "mortar/pair_gradients.h"
#include "mortar/segment_3d.h"

#include <string>

namespace mortar_tests
{
  struct Pair
  {
    std::string    name;
    FacetPositions slave, master;

    unsigned int n_dofs() const
    {
      return 6 * slave.n_nodes;
    }

    Pair with(const std::vector<double> &shift) const
    {
      Pair result = *this;
      for (unsigned int k = 0; k < n_dofs(); ++k)
        {
          FacetPositions &face =
            k < n_dofs() / 2 ? result.slave : result.master;
          face.x[(k / 3) % slave.n_nodes][k % 3] += shift[k];
        }
      return result;
    }

    Pair with(const unsigned int k, const double shift) const
    {
      std::vector<double> all(n_dofs(), 0.);
      all[k] = shift;
      return with(all);
    }
  };

  /// D, M and the area one after the other.
  inline std::vector<double> listed(const PairIntegrals<double> &pair)
  {
    std::vector<double> result;
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int B = 0; B < 4; ++B)
        {
          result.push_back(pair.D[A][B]);
          result.push_back(pair.M[A][B]);
        }
    result.push_back(pair.area);
    return result;
  }

  inline std::vector<double> values(const Pair        &pair,
                                    const PairOptions &options)
  {
    return listed(integrate_pair(pair.slave, pair.master, options));
  }

  /// The derivatives by entry k, in the order of listed().
  inline std::vector<double> listed(const PairGradients &pair,
                                    const unsigned int   k)
  {
    std::vector<double> result;
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int B = 0; B < 4; ++B)
        {
          result.push_back(pair.dD[A][B][k]);
          result.push_back(pair.dM[A][B][k]);
        }
    result.push_back(pair.darea[k]);
    return result;
  }

  inline PairGradients
  gradients(const Pair        &pair,
            const PairOptions &options,
            const DerivedBy    derived_by = DerivedBy::slave_and_master)
  {
    return pair_gradients(pair.slave, pair.master, options, derived_by);
  }

  inline double largest(const std::vector<double> &list)
  {
    double result = 0.;
    for (const double x : list)
      result = std::max(result, std::abs(x));
    return result;
  }

  inline double largest(const PairGradients &pair)
  {
    double result = 0.;
    for (unsigned int k = 0; k < 24; ++k)
      result = std::max(result, largest(listed(pair, k)));
    return result;
  }

  inline double distance(const std::vector<double> &a,
                         const std::vector<double> &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      result = std::max(result, std::abs(a[i] - b[i]));
    return result;
  }

  /// What the segments are made of; empty for lines.
  inline std::vector<unsigned int> topology(const Pair &pair)
  {
    std::vector<unsigned int> result;
    const auto plane  = auxiliary_plane(face_nodes(pair.slave), 4);
    const auto slave  = projected(plane, face_nodes(pair.slave), 4);
    const auto master = projected(plane, face_nodes(pair.master), 4);
    const auto found  = find_segments(slave, master);
    for (unsigned int i = 0; i < found.n_segments; ++i)
      for (unsigned int v = 0; v < found.segments[i].n_vertices; ++v)
        {
          const SegmentVertex &vertex = found.segments[i].vertices[v];
          result.push_back(static_cast<unsigned int>(vertex.origin));
          result.push_back(vertex.slave[0]);
          result.push_back(vertex.master[0]);
        }
    return result;
  }

  /// One pair per topology. All masters look down on the unit square.
  inline std::vector<Pair> topologies()
  {
    const auto pair = [](const std::string &name, const Corners &x) {
      return Pair{name, unit_square(), reversed(quad(x))};
    };
    std::vector<Pair> pairs{
      Pair{"eight crossings", unit_square(), master_T1()},
      Pair{"corner on corner", unit_square(), master_T2()},
      pair("slave inside",
           {{{{-.2, -.3, .1}},
             {{1.4, -.2, .1}},
             {{1.3, 1.2, 0.}},
             {{-.1, 1.5, .1}}}}),
      pair("master inside",
           {{{{.2, .2, .1}}, {{.8, .3, 0.}}, {{.7, .8, .1}}, {{.3, .7, 0.}}}}),
      pair(
        "strip",
        {{{{.3, -1., 0.}}, {{.6, -1., .1}}, {{.7, 2., 0.}}, {{.2, 2., .1}}}}),
      pair(
        "corner cut off",
        {{{{.8, -1., .1}}, {{2., .5, .1}}, {{2., 2., .1}}, {{-1., 2., 0.}}}}),
      pair("tip",
           {{{{.8, .5, .1}}, {{2., .2, .1}}, {{3., .5, .1}}, {{2., .8, 0.}}}}),
      pair("sliver",
           {{{{.99, -1., .1}},
             {{2., -1., .1}},
             {{2., 2., .1}},
             {{.995, 2., 0.}}}}),
      pair(
        "re-entrant master",
        {{{{.1, .2, .1}}, {{.5, .4, .1}}, {{1.2, .1, .1}}, {{.5, .9, 0.}}}})};
    Pair dart{"re-entrant slave", unit_square(), master_T1()};
    dart.slave.x[2] = Point<3>(.35, .45, 0.);
    pairs.push_back(dart);
    // Quad pair 2 of Kratos' tables of test pairs, master node 1 perturbed by
    // -5e-3 in x; unperturbed it is "aligned" below.
    Pair kratos = pair("quad pair 2",
                       {{{{0., 0., 1e-3}},
                         {{1., 0., 1e-3}},
                         {{1., 1., 1e-3}},
                         {{-.1, 1., 1e-3}}}});
    kratos.master.x[1][0] -= 5e-3;
    pairs.push_back(kratos);
    return pairs;
  }
} // namespace mortar_tests

#endif
