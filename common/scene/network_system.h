// SPDX-License-Identifier: LGPL-2.1-or-later
// From a network to its unknowns and its list of terms.
#ifndef demold_scene_network_system_h
#define demold_scene_network_system_h

#include "network/bond_links.h"
#include "scene/network_entries.h"
#include "scene/recorder.h"
#include "solution/strategy.h"
#include "weak_form/weak_form.h"

#include <functional>
#include <memory>
#include <optional>

namespace demold
{
  /// Two displacements per node, all on the first rank.
  class NetworkSystem
  {
  public:
    /// @p law of the bonds, if there are any.
    NetworkSystem(const NetworkEntries             &entries,
                  const std::optional<AdhesionLaw> &law,
                  MPI_Comm                          communicator);

    std::unique_ptr<WeakForm> weak_form;

    /// The state after the increment of @p record. Collective.
    Observation observe(const IncrementRecord &record) const;

  private:
    dealii::types::global_dof_index unknown(const unsigned int node,
                                            const unsigned int direction) const;

    std::vector<dealii::types::global_dof_index>
    unknowns(const Network::LinkEntry &link) const;

    Supports supports() const;
    void     add_terms(const std::optional<AdhesionLaw> &law);
    double   force_at(const Network::Component &component) const;

    const Network                              network;
    const std::map<unsigned int, unsigned int> numbers;  ///< of the unknowns
    const double                               end_time; ///< [s]
    std::function<double(double)>              motion, load;
    const MPI_Comm                             communicator;
    const bool       is_mine; ///< are the links of this rank?
    const BondLinks *bonds = nullptr;
  };
} // namespace demold

#endif
