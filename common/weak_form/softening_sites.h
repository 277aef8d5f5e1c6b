// SPDX-License-Identifier: LGPL-2.1-or-later
// What a path through softening needs to know of the points that soften.
#ifndef demold_weak_form_softening_sites_h
#define demold_weak_form_softening_sites_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <vector>

namespace demold
{
  /// One point that holds at t_n and may soften, seen at the trial state.
  struct SofteningSite
  {
    /// Unknowns that move the gap: d gap[components[k]] / d u(unknowns[k]) =
    /// weights[k] [-].
    std::vector<dealii::types::global_dof_index> unknowns;
    std::vector<unsigned int>                    components;
    std::vector<double>                          weights;

    dealii::Tensor<1, 3> gap;            ///< [mm]
    dealii::Tensor<1, 3> old_gap;        ///< [mm] at t_n
    double               effective = 0.; ///< [mm] one number for the gap
    dealii::Tensor<1, 3> direction;      ///< d effective/d gap [-]
    double               largest = 0.;   ///< [mm] effective gap up to t_n
    double               onset   = 0.;   ///< [mm] where softening begins
    double               rupture = 0.;   ///< [mm] where it ends
    double               area    = 0.;   ///< [mm^2]
    double               whole   = 0.;   ///< [mJ] released from first to last
    double               left    = 0.;   ///< [mJ] still to be released at t_n

    /// Released since t_n [mJ] and its derivative by the gap [N]. That of a
    /// driven point goes below 0 and beyond `left`, so that it has a slope
    /// everywhere (theory D.2).
    double               released = 0.;
    dealii::Tensor<1, 3> released_gradient;

    /// Effective gap over the one where softening begins or goes on [-].
    double utilisation = 0.;
    bool   driven      = false;
    bool   separated   = false; ///< in the trial state
  };

  /// A term with such points. Strategies find it by a cast.
  class SofteningTerm
  {
  public:
    virtual ~SofteningTerm() = default;

    /// Points of this rank, in an order that lasts until commit().
    virtual std::vector<SofteningSite> softening_sites() const = 0;

    /// Points, numbered as above, that take the softening branch in iteration
    /// 0, whatever their gap says: a bond on the point of giving way unloads
    /// or softens, and only the second makes a predictor for a path along
    /// which it goes on (theory D.2). Ends with commit() and revert().
    virtual void drive(const std::vector<bool> &points) = 0;
  };
} // namespace demold

#endif
