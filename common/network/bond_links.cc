// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds between nodes of a network.
#include "network/bond_links.h"

#include "contact/bond_force.h"
#include "contact/interface_term.h"
#include "contact/softening_site.h"
#include "weak_form/assembler.h"
#include "weak_form/vector_io.h"

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    Tensor<1, 3> normal()
    {
      Tensor<1, 3> n;
      n[1] = 1.;
      return n;
    }

    Assembler::Indices indices_of(const BondLink &link)
    {
      return {link.unknowns.begin(), link.unknowns.end()};
    }

    /// d gap[d]/d u of unknown k.
    double weight(const unsigned int k)
    {
      return k < 2 ? 1. : -1.;
    }
  } // namespace

  BondLinks::BondLinks(const AdhesionLaw           &law,
                       const std::vector<BondLink> &links)
    : law(law)
    , links(links)
    , points(links.size())
  {
    for (Point &point : points)
      {
        point.committed.bonded = true;
        point.committed.status = AdhesionStatus::adhering;
        point.trial            = point.committed;
      }
  }

  std::string BondLinks::name() const
  {
    return "bonds";
  }

  TermKind BondLinks::kind() const
  {
    return TermKind::interface;
  }

  bool BondLinks::symmetric() const
  {
    return law.symmetric();
  }

  void BondLinks::needed_unknowns(IndexSet &set) const
  {
    for (const BondLink &link : links)
      set.add_indices(link.unknowns.begin(), link.unknowns.end());
  }

  void
  BondLinks::add_couplings(DynamicSparsityPattern          &pattern,
                           const AffineConstraints<double> &constraints) const
  {
    for (const BondLink &link : links)
      constraints.add_entries_local_to_global(indices_of(link), pattern, false);
  }

  AdhesionResponse BondLinks::respond(const Point       &point,
                                      const unsigned int iteration) const
  {
    if (point.driven && iteration == 0)
      return law.evaluate(point.gap,
                          normal(),
                          point.committed.state,
                          AdhesionStatus::decohesion);
    return bond_response(law,
                         point.gap,
                         normal(),
                         point.committed,
                         point.last,
                         {iteration});
  }

  bool BondLinks::assemble(const Configuration &now, Assembler &assembler)
  {
    state_changes = 0;
    if (law.viscous_time > 0.)
      law = law.over(now.elapsed);
    for (std::size_t p = 0; p < links.size(); ++p)
      {
        const auto indices = indices_of(links[p]);
        Point     &point   = points[p];
        point.gap          = Tensor<1, 3>();
        for (unsigned int k = 0; k < 4; ++k)
          point.gap[k % 2] += weight(k) * now.u(indices[k]);
        const AdhesionResponse r = respond(point, now.iteration);
        state_changes += r.status != point.last ? 1 : 0;
        point.last         = r.status;
        point.trial.status = r.status;
        point.trial.state  = r.state;
        point.stored       = links[p].area * r.stored;
        point.taken =
          point.accepted_taken + links[p].area * r.regularisation_increment;

        dealii::Vector<double> R(4);
        FullMatrix<double>     K(4, 4);
        for (unsigned int i = 0; i < 4; ++i)
          {
            R(i) = links[p].area * weight(i) * r.traction[i % 2];
            for (unsigned int j = 0; j < 4; ++j)
              K(i, j) =
                links[p].area * weight(i) * weight(j) * r.dt_dg[i % 2][j % 2];
          }
        if (assembler.with_tangent())
          assembler.add(indices, R, K);
        else
          assembler.add(indices, R);
      }
    return true;
  }

  unsigned int BondLinks::n_state_changes() const
  {
    return state_changes;
  }

  IncrementError BondLinks::increment_error() const
  {
    double lost = 0., front = 0.;
    for (std::size_t p = 0; p < links.size(); ++p)
      {
        const double d = points[p].trial.state.dissipated -
                         points[p].committed.state.dissipated;
        lost += links[p].area * d;
        front += d > 0. ? links[p].area : 0.;
      }
    return decohesion_error(law, lost, front, MPI_COMM_WORLD);
  }

  Energies BondLinks::energies() const
  {
    Energies e;
    for (std::size_t p = 0; p < links.size(); ++p)
      {
        e.stored += points[p].stored;
        e.adhesion += links[p].area * points[p].trial.state.dissipated;
        e.regularisation += points[p].taken;
      }
    return e;
  }

  void BondLinks::commit()
  {
    for (Point &point : points)
      {
        point.committed       = point.trial;
        point.accepted_stored = point.stored;
        point.accepted_taken  = point.taken;
        point.driven          = false;
      }
  }

  void BondLinks::revert()
  {
    for (Point &point : points)
      {
        point.trial  = point.committed;
        point.stored = point.accepted_stored;
        point.taken  = point.accepted_taken;
        point.driven = false;
      }
  }

  std::size_t BondLinks::history_bytes() const
  {
    return points.size() * sizeof(Point);
  }

  void BondLinks::save(std::ostream &out) const
  {
    std::vector<double> values;
    for (const Point &point : points)
      {
        const AdhesionState &s = point.committed.state;
        for (const double x : {s.kappa,
                               s.dissipated,
                               s.strength_factor,
                               s.pressed_time,
                               s.gap[0],
                               s.gap[1],
                               s.gap[2],
                               point.accepted_stored,
                               point.accepted_taken,
                               static_cast<double>(point.committed.status)})
          values.push_back(x);
      }
    write_values(out, values);
  }

  void BondLinks::load(std::istream &in)
  {
    const auto  values = read_values(in);
    std::size_t next   = 0;
    for (Point &point : points)
      {
        AdhesionState &s = point.committed.state;
        for (double *x : {&s.kappa,
                          &s.dissipated,
                          &s.strength_factor,
                          &s.pressed_time,
                          &s.gap[0],
                          &s.gap[1],
                          &s.gap[2],
                          &point.accepted_stored,
                          &point.accepted_taken})
          *x = values.at(next++);
        const auto status      = static_cast<int>(values.at(next++));
        point.committed.status = static_cast<AdhesionStatus>(status);
        point.last             = point.committed.status;
      }
    revert();
  }

  bool BondLinks::holds(const Point &point) const
  {
    return point.committed.status != AdhesionStatus::separated;
  }

  std::vector<SofteningSite> BondLinks::softening_sites() const
  {
    std::vector<SofteningSite> list;
    for (std::size_t p = 0; p < links.size(); ++p)
      {
        const Point &at = points[p];
        if (!holds(at))
          continue;
        SofteningSite point = softening_site(law,
                                             at.gap,
                                             normal(),
                                             at.committed.state,
                                             links[p].area,
                                             at.driven);
        point.unknowns      = indices_of(links[p]);
        for (unsigned int k = 0; k < 4; ++k)
          {
            point.components.push_back(k % 2);
            point.weights.push_back(weight(k));
          }
        list.push_back(point);
      }
    return list;
  }

  void BondLinks::drive(const std::vector<bool> &driven)
  {
    std::size_t next = 0;
    for (Point &point : points)
      point.driven = holds(point) && driven.at(next++);
  }

  double BondLinks::bonded_area() const
  {
    double sum = 0.;
    for (std::size_t p = 0; p < links.size(); ++p)
      if (points[p].trial.status != AdhesionStatus::separated)
        sum += links[p].area;
    return sum;
  }

  double BondLinks::area() const
  {
    double sum = 0.;
    for (const BondLink &link : links)
      sum += link.area;
    return sum;
  }
} // namespace demold
