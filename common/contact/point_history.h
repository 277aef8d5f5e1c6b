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

  /// Stick point of friction and what it holds.
  struct FrictionHistory
  {
    bool                 active = false;
    Anchor               stick;
    dealii::Tensor<1, 3> traction;   ///< [MPa]
    double               limit = 0.; ///< mu p [MPa]

    /// Did the point slide at the end of the step?
    bool slips() const
    {
      return limit > 0. && traction.norm() >= (1. - 1e-10) * limit;
    }

    template <typename Archive>
    void serialize(Archive &archive)
    {
      archive &active &stick &traction &limit;
    }
  };

  /// Bond of one point.
  struct BondHistory
  {
    bool                 bonded = false; ///< was there ever a bond?
    AdhesionState        state;
    Anchor               anchor;
    AdhesionStatus       status          = AdhesionStatus::separated;
    double               separation_time = -1.; ///< [s], -1: never
    dealii::Tensor<1, 3> force;                 ///< [N] on the slave

    template <typename Archive>
    void serialize(Archive &archive)
    {
      archive &bonded &state.kappa &state.dissipated &state
        .strength_factor &state.pressed_time  &state
        .gap &anchor &status &separation_time &force;
    }
  };

  /// All points of one rank; friction and bonds only if the interface has any.
  struct PointHistories
  {
    std::vector<ContactHistory>  contact;
    std::vector<FrictionHistory> friction;
    std::vector<BondHistory>     bond;

    template <typename Archive>
    void serialize(Archive &archive)
    {
      for (auto &h : contact)
        h.serialize(archive);
      for (auto &h : friction)
        h.serialize(archive);
      for (auto &h : bond)
        h.serialize(archive);
    }

    /// Does the point have a bond that is not ruptured?
    bool holds(const unsigned int p) const
    {
      return !bond.empty() && bond[p].bonded &&
             bond[p].status != AdhesionStatus::separated;
    }

    std::size_t bytes() const
    {
      return contact.size() * sizeof(ContactHistory) +
             friction.size() * sizeof(FrictionHistory) +
             bond.size() * sizeof(BondHistory);
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
        *this &x.facet &x.xi[0] & x.xi[1] &
          x.material &x.material_normal &x.offset;
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
        *this &x.facet &x.xi[0] & x.xi[1] &
          x.material &x.material_normal &x.offset;
      else
        x = static_cast<Number>(values.at(next++));
      return *this;
    }
  };
} // namespace demold

#endif
