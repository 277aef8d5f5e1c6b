// SPDX-License-Identifier: LGPL-2.1-or-later
// A small block of rubber on a mould or on another block, ready to be solved.
#ifndef demold_tests_weak_form_block_on_mould_h
#define demold_tests_weak_form_block_on_mould_h

#include "contact/interface_description.h"
#include "contact/interface_term.h"
#include "contact/master.h"
#include "solution/inertia.h"
#include "solution/linear_solver.h"
#include "solution/newton.h"
#include "weak_form/weak_form.h"

#include <memory>
#include <string>

namespace demold
{
  /// What the scene is made of; what is not asked for is not there.
  struct BlockOptions
  {
    bool                                viscous = false;
    std::optional<InterfaceDescription> interface;
    bool                                mortar   = false; ///< else nodes
    bool                                on_block = false; ///< else on a mould
    RigidMotion mould = [](double) { return RigidPlacement(); };

    /// Displacement [mm] of a point of the top at a time; empty: free.
    std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &, double)> top;

    /// [MPa] on the top; empty: none.
    std::function<dealii::Tensor<1, 3>(double)> traction;

    std::optional<TimeIntegrator> integrator; ///< with one: dynamics
    double                        residual_tolerance = 1e-9;
  };

  /// Plane-strain block [0,2] x [0,1] mm of 4 x 3 cells, 1 mm thick. The mould
  /// is the line y = 0, the other block [-1,3] x [-1,0] of 5 x 2 cells, held
  /// at its bottom.
  class BlockOnMould
  {
  public:
    explicit BlockOnMould(const BlockOptions &options);
    ~BlockOnMould();

    /// Goes to @p time in one increment and accepts it.
    NewtonReport advance(const double time);

    /// The same, but the increment is dropped in the end.
    NewtonReport try_and_reject(const double time);

    /// Assembles twice at nonsense, noise of @p amplitude [mm] on all
    /// unknowns, as Newton could on its way; nothing is accepted.
    void assemble_noise(const double time, const double amplitude);

    /// Committed state, bitwise.
    std::string saved() const;

    void load(const std::string &state);

    /// Gives all nodes the velocity @p v [mm/s].
    void throw_with(const dealii::Tensor<1, 3> &v);

    std::unique_ptr<WeakForm>     form;
    InterfaceTerm                *contact = nullptr;
    Inertia                      *inertia = nullptr;
    std::unique_ptr<LinearSolver> solver;
    std::unique_ptr<Newton>       newton;
    const BlockOptions            options;

  private:
    struct Mesh;
    std::unique_ptr<Mesh> mesh;

    NewtonReport solve(const double time);
  };
} // namespace demold

#endif
