// SPDX-License-Identifier: LGPL-2.1-or-later
// What one slave point remembers between increments.
#ifndef demold_contact_point_history_h
#define demold_contact_point_history_h

#include "adhesion/adhesion_law.h"
#include "contact/master.h"

#include <vector>

namespace demold
{
  /// Contact of one point at the end of an increment.
  struct ContactHistory
  {
    bool                 closed     = false;
    unsigned int         last_facet = dealii::numbers::invalid_unsigned_int;
    double               gap        = 1e300; ///< [mm]
    dealii::Tensor<1, 3> force; ///< [N] on the slave, contact and friction

    template <typename Archive>
    void serialize(Archive &archive)
    {
      archive &closed &last_facet &gap &force;
    }
  };

  /// Stick point of friction.
  struct FrictionHistory
  {
    bool   active = false;
    Anchor stick;

    template <typename Archive>
    void serialize(Archive &archive)
    {
      archive &active &stick;
    }
  };

  /// Bond of one point.
  struct BondHistory
  {
    bool                 bonded = false; ///< was there ever a bond?
    AdhesionState        state;
    Anchor               anchor;
    AdhesionStatus       status = AdhesionStatus::separated;
    double               separation_time = -1.; ///< [s], -1: never
    dealii::Tensor<1, 3> force;                 ///< [N] on the slave

    template <typename Archive>
    void serialize(Archive &archive)
    {
      archive &bonded &state.kappa &state.dissipated &state.strength_factor
        &state.pressed_time &state.gap &anchor &status &separation_time &force;
    }
  };

  /// Archive that appends to a list of numbers.
  struct HistoryWriter
  {
    std::vector<double> values;

    template <typename Number>
    HistoryWriter &operator&(Number &x)
    {
      if constexpr (std::is_same_v<Number, dealii::Tensor<1, 3>> ||
                    std::is_same_v<Number, dealii::Point<3>>)
        for (unsigned int d = 0; d < 3; ++d)
          values.push_back(x[d]);
      else if constexpr (std::is_same_v<Number, Anchor>)
        *this &x.facet &x.xi[0] &x.xi[1] &x.material &x.material_normal
          &x.offset;
      else
        values.push_back(static_cast<double>(x));
      return *this;
    }
  };

  /// Archive that reads them back in the same order.
  struct HistoryReader
  {
    const std::vector<double> &values;
    std::size_t                next = 0;

    template <typename Number>
    HistoryReader &operator&(Number &x)
    {
      if constexpr (std::is_same_v<Number, dealii::Tensor<1, 3>> ||
                    std::is_same_v<Number, dealii::Point<3>>)
        for (unsigned int d = 0; d < 3; ++d)
          x[d] = values.at(next++);
      else if constexpr (std::is_same_v<Number, Anchor>)
        *this &x.facet &x.xi[0] &x.xi[1] &x.material &x.material_normal
          &x.offset;
      else
        x = static_cast<Number>(values.at(next++));
      return *this;
    }
  };
} // namespace demold

#endif
