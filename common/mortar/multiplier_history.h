// SPDX-License-Identifier: LGPL-2.1-or-later
// What one multiplier point remembers between increments.
#ifndef demold_mortar_multiplier_history_h
#define demold_mortar_multiplier_history_h

#include "adhesion/traction_resolvent.h"
#include "contact/master.h"
#include "mortar/nodal_row.h"

namespace demold
{
  /// The mortar row frozen when a point was bonded (theory B.6a, B4). The
  /// master side of a rigid mould is one remembered point, in `anchor`; that
  /// of a deformable one are the weights on its nodes, and `anchor` turns the
  /// gap that was there at bonding with the facet.
  struct FrozenRow
  {
    NodalRow row; ///< without derivatives; rigid mould: slave nodes only
    Anchor   anchor;
  };

  /// The rest of the history, the same size for every point.
  struct MultiplierHistory
  {
    ResolventState       law;
    int                  number          = 6;   ///< state of theory C.5
    double               separation_time = -1.; ///< [s], -1: never
    bool                 closed          = false;
    bool                 has_gap         = false; ///< is anything opposite?
    dealii::Tensor<1, 3> gap; ///< [mm]: whole gap of a bond, else g_N n + slip
    double               gap_N = 0.; ///< [mm]
    dealii::Tensor<1, 3> traction;   ///< lambda [MPa]
    dealii::Tensor<1, 3> sprung;     ///< [MPa] what strains its compliance
    double               area = 0.;  ///< [mm^2] covered

    dealii::Tensor<1, 3> force() const ///< [N] on the slave
    {
      return area * traction;
    }

    template <typename Archive>
    void serialize(Archive &archive)
    {
      law.serialize(archive, 0);
      archive &number &separation_time &closed &has_gap &gap &gap_N &traction
        &sprung &area;
    }
  };
} // namespace demold

#endif
