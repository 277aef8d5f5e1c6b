// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton converges quadratically with full tangents: in contact, stick, slip
// and decohesion, on a mould and on a deformable block.
#include "weak_form/block_on_mould.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace demold;
using dealii::Tensor;

namespace
{
  /// Two states of the held top [mm]; the second one is reached from the first
  /// in one increment.
  struct Path
  {
    double x0, y0, x1, y1;
  };

  struct Formulation
  {
    const char *name;
    bool        mortar, dual, condensed;
  };

  constexpr Formulation formulations[] = {
    {"node to segment", false, false, false},
    {"mortar, standard multipliers", true, false, false},
    {"mortar, dual multipliers", true, true, false},
    {"mortar, condensed multipliers", true, true, true}};

  BlockOptions options(const InterfaceDescription &interface,
                       const Formulation          &formulation,
                       const Path                 &path,
                       const bool                  on_block)
  {
    BlockOptions result;
    result.interface                   = interface;
    result.interface->dual_multipliers = formulation.dual;
    result.interface->condensed        = formulation.condensed;
    result.interface->stiffness        = 3.; // of the order of E [MPa]
    result.mortar                      = formulation.mortar;
    result.on_block                    = on_block;
    result.residual_tolerance          = 1e-14;
    result.top = [path](const dealii::Point<3> &, const double t) {
      return t < 1.5 ? Tensor<1, 3>({path.x0, path.y0, 0.}) :
                       Tensor<1, 3>({path.x1, path.y1, 0.});
    };
    return result;
  }

  /// Noise of @p amplitude [mm] on all free unknowns.
  Vector noise(const WeakForm &form, const double amplitude)
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> distribution(-amplitude, amplitude);
    Vector                                 result = form.new_vector();
    for (const auto i : result.locally_owned_elements())
      result(i) = distribution(generator);
    result.compress(dealii::VectorOperation::insert);
    form.set_supports_to_zero(result);
    return result;
  }

  /// Unbalanced force [N] after one correction from @p solution plus noise.
  double residual_after_one_correction(BlockOnMould &block,
                                       const Vector &solution,
                                       const double  amplitude)
  {
    WeakForm &form = *block.form;
    form.trial     = solution;
    form.trial += noise(form, amplitude);
    form.assemble(true, 1);
    Vector correction = form.new_vector();
    block.solver->solve(form.matrix,
                        correction,
                        form.right_hand_side,
                        1e-12,
                        false,
                        form.has_extra_unknowns());
    form.update(correction, 1.);
    form.assemble(false, 2);
    const ResidualNorms norms = form.residual_norms();
    return std::max(norms.free, norms.extra);
  }

  /// Near the end, each residual is of the order of the square of the last. The
  /// factor depends on the way there: a bond at t_n is on the kink of its law,
  /// and round-off decides which tangent iteration 0 takes. That the order is
  /// two is shown below, without a factor.
  void expect_squares(const std::vector<double> &residuals)
  {
    unsigned int n = 0;
    for (unsigned int k = 1; k + 1 < residuals.size(); ++k)
      if (residuals[k] > 0. && residuals[k] < 1e-2)
        {
          EXPECT_LE(residuals[k + 1], 30. * residuals[k] * residuals[k] + 1e-12)
            << "after iteration " << k;
          ++n;
        }
    EXPECT_GE(n, 1u) << "too few iterations to tell";
  }

  /// Solves the second increment, then asks what one more correction leaves of
  /// a small error: a quarter of it leaves a sixteenth.
  void check_order(BlockOnMould &block, const std::vector<int> &states)
  {
    ASSERT_TRUE(block.advance(1.).converged);
    block.form->begin_increment(2., 0.);
    const NewtonReport report = block.newton->solve(*block.form);
    ASSERT_TRUE(report.converged) << report.reason;
    expect_squares(report.residuals);
    for (const PointReport &point : block.contact->report())
      EXPECT_NE(std::find(states.begin(), states.end(), point.state),
                states.end())
        << "state " << point.state;

    const Vector solution(block.form->trial);
    double       last = 0.;
    for (const double amplitude : {1e-4, .25e-4, .0625e-4})
      {
        const double residual =
          residual_after_one_correction(block, solution, amplitude);
        if (last > 0.)
          {
            EXPECT_GE(std::log(last / residual) / std::log(4.), 1.9);
          }
        last = residual;
      }
  }

  void check_order(const InterfaceDescription &interface,
                   const Path                 &path,
                   const std::vector<int>     &states)
  {
    for (const Formulation &formulation : formulations)
      for (const bool on_block : {false, true})
        {
          if (formulation.condensed && on_block)
            continue; // on a mould only
          SCOPED_TRACE(std::string(formulation.name) +
                       (on_block ? ", on a block" : ", on a mould"));
          BlockOnMould block(options(interface, formulation, path, on_block));
          check_order(block, states);
        }
  }

  InterfaceDescription bonded()
  {
    InterfaceDescription interface;
    AdhesionLaw          law;
    law.softening      = LinearSoftening{.05, .2, 20.};
    law.factors        = mode_factors(ModeMixing::energy, .6);
    interface.adhesion = law;
    return interface;
  }
} // namespace

TEST(NewtonOrder, is_two_in_contact_without_friction)
{
  check_order(InterfaceDescription(), {0., -.02, .02, -.1}, {4});
}

TEST(NewtonOrder, is_two_in_stick)
{
  InterfaceDescription interface;
  interface.friction = 2.;
  check_order(interface, {0., -.04, .05, -.05}, {4});
}

TEST(NewtonOrder, is_two_in_slip)
{
  InterfaceDescription interface;
  interface.friction = .02;
  check_order(interface, {0., -.04, .1, -.05}, {5});
}

TEST(NewtonOrder, is_two_in_decohesion)
{
  check_order(bonded(), {.1, .03, .12, .05}, {1});
}
