// SPDX-License-Identifier: LGPL-2.1-or-later
// From a network to its unknowns and its list of terms.
#include "scene/network_system.h"

#include "network/link_term.h"
#include "network/nodal_load.h"
#include "scene/expression.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::function<double(double)> formula(const std::string &text,
                                          const std::string &path)
    {
      const auto expression = std::make_shared<Expression>(text, path);
      return [expression](const double t) { return (*expression)(t); };
    }

    bool is_same(const Network::Component &a, const Network::Component &b)
    {
      return a.node == b.node && a.direction == b.direction;
    }

    bool contains(const std::vector<Network::Component> &list,
                  const Network::Component              &component)
    {
      return std::any_of(list.begin(), list.end(), [&](const auto &other) {
        return is_same(other, component);
      });
    }

    DisplacementSpace space_of(const unsigned int n,
                               const bool         is_mine,
                               MPI_Comm           communicator)
    {
      const IndexSet set = is_mine ? complete_index_set(n) : IndexSet(n);
      return {communicator,
              set,
              set,
              [](DynamicSparsityPattern &, const AffineConstraints<double> &) {
              }};
    }
  } // namespace

  NetworkSystem::NetworkSystem(const NetworkEntries             &entries,
                               const std::optional<AdhesionLaw> &law,
                               MPI_Comm                          communicator)
    : network(entries.network())
    , numbers(network.unknowns())
    , end_time(entries.end_time)
    , motion(formula(entries.motion, "Network/motion"))
    , load(formula(entries.load, "Network/load"))
    , communicator(communicator)
    , is_mine(Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    weak_form = std::make_unique<WeakForm>(space_of(numbers.size(),
                                                    is_mine,
                                                    communicator),
                                           supports());
    add_terms(law);
    weak_form->setup();
  }

  types::global_dof_index
  NetworkSystem::unknown(const unsigned int node,
                         const unsigned int direction) const
  {
    return numbers.at(2 * node + direction);
  }

  /// Displacements of both ends of a bar or bond.
  std::vector<types::global_dof_index>
  NetworkSystem::unknowns(const Network::LinkEntry &link) const
  {
    return {unknown(link.a, 0),
            unknown(link.a, 1),
            unknown(link.b, 0),
            unknown(link.b, 1)};
  }

  Supports NetworkSystem::supports() const
  {
    Supports            result;
    std::vector<double> signs;
    const auto          has_unknown = [this](const Network::Component &c) {
      return numbers.count(2 * c.node + c.direction) > 0;
    };
    for (const auto &component : network.driven)
      if (has_unknown(component))
        {
          result.unknowns.push_back(
            unknown(component.node, component.direction));
          signs.push_back(component.sign);
        }
    for (const auto &component : network.held)
      if (has_unknown(component) && !contains(network.driven, component))
        {
          result.unknowns.push_back(
            unknown(component.node, component.direction));
          signs.push_back(0.);
        }
    result.values = [signs, motion = motion](const double         t,
                                             std::vector<double> &values) {
      for (std::size_t k = 0; k < signs.size(); ++k)
        values[k] = signs[k] * motion(t);
    };
    return result;
  }

  void NetworkSystem::add_terms(const std::optional<AdhesionLaw> &law)
  {
    std::vector<Spring>   springs;
    std::vector<Bar>      bars;
    std::vector<BondLink> links;
    if (is_mine)
      {
        for (const auto &s : network.springs)
          springs.push_back(
            {{unknown(s.a, s.direction), unknown(s.b, s.direction)},
             s.stiffness});
        for (const auto &l : network.bars)
          bars.push_back(
            {unknowns(l), network.nodes[l.a], network.nodes[l.b], l.size});
        for (const auto &l : network.bonds)
          {
            const auto list = unknowns(l);
            links.push_back({{{list[0], list[1], list[2], list[3]}}, l.size});
          }
      }
    if (!network.springs.empty())
      weak_form->add(std::make_unique<LinkTerm<Spring>>("springs", springs));
    if (!network.bars.empty())
      weak_form->add(std::make_unique<LinkTerm<Bar>>("bars", bars));
    for (const auto &component : network.loaded)
      weak_form->add(std::make_unique<NodalLoad>(
        unknown(component.node, component.direction),
        is_mine,
        [component, load = load](const double t) {
          return component.sign * load(t);
        }));
    if (!network.bonds.empty() && law)
      bonds = &dynamic_cast<const BondLinks &>(
        weak_form->add(std::make_unique<BondLinks>(*law, links)));
  }

  /// Of a support its reaction, of anything else its load.
  double NetworkSystem::force_at(const Network::Component &component) const
  {
    for (const auto &loaded : network.loaded)
      if (is_same(loaded, component))
        return component.sign * loaded.sign * load(weak_form->time());
    return is_mine ?
             component.sign *
               weak_form->force(unknown(component.node, component.direction)) :
             0.;
  }

  Observation NetworkSystem::observe(const IncrementRecord &record) const
  {
    const auto sum = [this](const double x) {
      return Utilities::MPI::sum(is_mine ? x : 0., communicator);
    };
    const Network::Component &at = network.opening.front();
    Observation               now;
    now.time    = record.path ? record.path->clock : record.time;
    now.opening = sum(
      is_mine ? at.sign * weak_form->accepted(unknown(at.node, at.direction)) :
                0.);
    now.force      = sum(force_at(at));
    now.energies   = weak_form->energies();
    now.iterations = record.newton.iterations;
    now.rejected   = record.rejected;
    now.strategy   = record.strategy;
    now.path       = record.path;
    now.done       = now.time / end_time;
    if (bonds != nullptr)
      {
        now.bonded = sum(bonds->bonded_area());
        now.area   = sum(bonds->area());
      }
    return now;
  }
} // namespace demold
