// SPDX-License-Identifier: LGPL-2.1-or-later
// R-tree over inflated facet boxes, queried with the slave nodes.
#include "contact/candidate_search.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using TreePoint =
      boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
    using Box   = boost::geometry::model::box<TreePoint>;
    using Entry = std::pair<Box, unsigned int>;

    /// Box around a facet, @p margin [mm] wider on every side.
    Box inflated_box(const FacetPositions &facet, double margin)
    {
      Point<3> low = facet.x[0], high = facet.x[0];
      for (unsigned int i = 1; i < facet.n_nodes; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c]  = std::min(low[c], facet.x[i][c]);
            high[c] = std::max(high[c], facet.x[i][c]);
          }
      // A foot may lie off a free end; xi = 1 + tolerance is half as much
      // in facet lengths.
      margin += free_end_tolerance * (high - low).norm();
      return {{low[0] - margin, low[1] - margin, low[2] - margin},
              {high[0] + margin, high[1] + margin, high[2] + margin}};
    }

    bool has_moved(const std::vector<Point<3>> &now,
                   const std::vector<Point<3>> &then,
                   const double                 distance)
    {
      if (now.size() != then.size())
        return true;
      for (unsigned int i = 0; i < now.size(); ++i)
        // Written such that a NaN counts as moved.
        if (!((now[i] - then[i]).norm() <= distance))
          return true;
      return false;
    }
  } // namespace

  CandidateSearch::CandidateSearch(const double reach, const double skin)
    : reach(reach)
    , skin(skin)
  {}

  bool CandidateSearch::is_outdated(const ContactSurface        &master,
                                    const std::vector<Point<3>> &slaves) const
  {
    return !is_built || has_moved(slaves, old_slaves, 0.5 * skin) ||
           has_moved(master.positions(), old_master, 0.5 * skin);
  }

  void CandidateSearch::rebuild(const ContactSurface        &master,
                                const std::vector<Point<3>> &slaves)
  {
    std::vector<Entry> boxes;
    boxes.reserve(master.n_facets());
    for (unsigned int f = 0; f < master.n_facets(); ++f)
      boxes.emplace_back(inflated_box(master.facet_positions(f), reach + skin),
                         f);
    const boost::geometry::index::rtree<Entry,
                                        boost::geometry::index::rstar<16>>
      tree(boxes);

    facets.assign(slaves.size(), {});
    std::vector<Entry> found;
    for (unsigned int s = 0; s < slaves.size(); ++s)
      {
        found.clear();
        const TreePoint x(slaves[s][0], slaves[s][1], slaves[s][2]);
        tree.query(boost::geometry::index::intersects(x),
                   std::back_inserter(found));
        for (const Entry &entry : found)
          facets[s].push_back(entry.second);
        std::sort(facets[s].begin(), facets[s].end());
      }
    old_master = master.positions();
    old_slaves = slaves;
    is_built   = true;
  }
} // namespace demold
