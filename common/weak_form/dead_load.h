// SPDX-License-Identifier: LGPL-2.1-or-later
// What a load that does not turn would do if it stopped changing.
#ifndef demold_weak_form_dead_load_h
#define demold_weak_form_dead_load_h

namespace demold
{
  /// A term whose load depends on time alone. A jump under such a load gets
  /// work from it: the load at that time times the displacement.
  class DeadLoad
  {
  public:
    virtual ~DeadLoad() = default;

    /// Load at @p time [s] times the displacements of the last assembly [mJ],
    /// this rank's share.
    virtual double potential(double time) const = 0;
  };
} // namespace demold

#endif
