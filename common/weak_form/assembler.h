// SPDX-License-Identifier: LGPL-2.1-or-later
// Where terms put their element vectors and matrices.
#ifndef demold_weak_form_assembler_h
#define demold_weak_form_assembler_h

#include "weak_form/algebra.h"
#include "weak_form/matrix_inserter.h"

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace demold
{
  /// Receives what the terms compute, piece by piece. The residual is kept
  /// unconstrained, so that it holds the reactions at the supports; matrix and
  /// right hand side are condensed by the constraints as they come in.
  class Assembler
  {
  public:
    using Indices = std::vector<dealii::types::global_dof_index>;

    virtual ~Assembler() = default;

    /// Is the tangent wanted, or the residual alone?
    virtual bool with_tangent() const = 0;

    /// Adds the residual [N] of the unknowns @p indices.
    virtual void add(const Indices                &indices,
                     const dealii::Vector<double> &residual) = 0;

    /// Adds residual [N] and tangent [N/mm].
    virtual void add(const Indices                    &indices,
                     const dealii::Vector<double>     &residual,
                     const dealii::FullMatrix<double> &tangent) = 0;
  };

  /// The assembler of the real system.
  class SystemAssembler : public Assembler
  {
  public:
    /// @p matrix may be null: residual only. The tangent is multiplied by
    /// @p weight, the residual is not (theory D.4: the weak form blends it).
    SystemAssembler(const dealii::AffineConstraints<double> &constraints,
                    Vector                                  &residual,
                    Vector                                  &right_hand_side,
                    SparseMatrix                            *matrix,
                    const bool                               inhomogeneous)
      : constraints(constraints)
      , residual(residual)
      , right_hand_side(right_hand_side)
      , matrix(matrix)
      , inhomogeneous(inhomogeneous)
    {}

    bool with_tangent() const override
    {
      return matrix != nullptr;
    }

    void add(const Indices &indices, const dealii::Vector<double> &r) override
    {
      residual.add(indices, r);
    }

    void add(const Indices                    &indices,
             const dealii::Vector<double>     &r,
             const dealii::FullMatrix<double> &K) override;

    /// Factor on the tangents that follow.
    double weight = 1.;

  private:
    const dealii::AffineConstraints<double> &constraints;
    Vector                                  &residual;
    Vector                                  &right_hand_side;
    SparseMatrix                            *matrix;
    const bool                               inhomogeneous;
    MatrixInserter                           inserter;
    dealii::FullMatrix<double>               scaled;
    dealii::Vector<double>                   zero;
  };
} // namespace demold

#endif
