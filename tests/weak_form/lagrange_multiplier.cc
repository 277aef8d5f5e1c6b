// SPDX-License-Identifier: LGPL-2.1-or-later
// The Term interface carries terms with unknowns of their own: a multiplier
// that prescribes one displacement gives what a support would give.
#include "solid/finite_strain_solid.h"
#include "solution/linear_solver.h"
#include "solution/newton.h"
#include "solution/residual_measure.h"
#include "test_rubber.h"
#include "weak_form/assembler.h"
#include "weak_form/displacement_space.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

using namespace dealii;

namespace
{
  /// lambda (u_i - value) = 0: one unknown, one constraint row.
  class HeldUnknown : public demold::Term
  {
  public:
    HeldUnknown(const types::global_dof_index held,
                const unsigned int            owner,
                const double                  value)
      : held(held)
      , owner(owner)
      , value(value)
    {}

    std::string name() const override
    {
      return "held unknown";
    }

    demold::TermKind kind() const override
    {
      return demold::TermKind::interface;
    }

    bool symmetric() const override
    {
      return true;
    }

    std::vector<unsigned int> extra_unknown_owners() const override
    {
      return {owner};
    }

    void set_first_extra_unknown(const types::global_dof_index i) override
    {
      multiplier = i;
    }

    void needed_unknowns(IndexSet &set) const override
    {
      set.add_index(held);
      set.add_index(multiplier);
    }

    void
    add_couplings(DynamicSparsityPattern          &pattern,
                  const AffineConstraints<double> &constraints) const override
    {
      if (mine())
        constraints.add_entries_local_to_global(
          std::vector<types::global_dof_index>{held, multiplier},
          pattern,
          false);
    }

    bool assemble(const demold::Configuration &now,
                  demold::Assembler           &assembler) override
    {
      if (!mine())
        return true;
      dealii::Vector<double> r(2);
      FullMatrix<double>     K(2, 2);
      r(0)    = now.u(multiplier);
      r(1)    = now.u(held) - value;
      K(0, 1) = K(1, 0) = 1.;
      if (assembler.with_tangent())
        assembler.add({held, multiplier}, r, K);
      else
        assembler.add({held, multiplier}, r);
      return true;
    }

    demold::Energies energies() const override
    {
      return {};
    }

    void commit() override
    {}

    void revert() override
    {}

    std::size_t history_bytes() const override
    {
      return 0;
    }

    bool mine() const
    {
      return owner == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    }

    const types::global_dof_index held;
    types::global_dof_index       multiplier = 0;
    const unsigned int            owner;
    const double                  value;
  };

  struct Block
  {
    Block()
      : mesh(MPI_COMM_WORLD,
             Triangulation<2>::none,
             false,
             parallel::shared::Triangulation<2>::Settings::partition_metis)
      , fe(FE_Q<2>(1), 2)
      , dofs(mesh)
    {
      GridGenerator::subdivided_hyper_rectangle(mesh,
                                                {4, 3},
                                                Point<2>(0., 0.),
                                                Point<2>(4., 3.));
      dofs.distribute_dofs(fe);
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            if (cell->vertex(v)[1] == 0.)
              for (unsigned int d = 0; d < 2; ++d)
                fixed.insert(cell->vertex_dof_index(v, d));
            if (cell->vertex(v).distance(Point<2>(4., 3.)) < 1e-12)
              corner = cell->vertex_dof_index(v, 1);
          }
    }

    std::unique_ptr<demold::WeakForm>
    weak_form(const bool corner_is_support) const
    {
      demold::Supports supports;
      supports.unknowns.assign(fixed.begin(), fixed.end());
      if (corner_is_support)
        supports.unknowns.push_back(corner);
      const std::size_t n_fixed = fixed.size();
      supports.values = [n_fixed](double, std::vector<double> &values) {
        for (std::size_t k = 0; k < values.size(); ++k)
          values[k] = k < n_fixed ? 0. : .3;
      };
      auto form =
        std::make_unique<demold::WeakForm>(demold::displacement_space<2>(dofs),
                                           supports);
      demold::SolidDescription description;
      description.element = "q1p0";
      description.law = [](const Point<3> &) { return demold::test_rubber(); };
      form->add(demold::make_solid_term<2>(dofs, description));
      return form;
    }

    parallel::shared::Triangulation<2> mesh;
    FESystem<2>                        fe;
    DoFHandler<2>                      dofs;
    std::set<types::global_dof_index>  fixed;
    types::global_dof_index            corner = 0;
  };

  void solve(demold::WeakForm &form)
  {
    demold::LinearSolverParameters linear;
    demold::LinearSolver           solver(linear, MPI_COMM_WORLD);
    demold::NewtonParameters       parameters;
    parameters.residual_tolerance = 1e-12;
    demold::Newton newton(parameters, solver);
    form.begin_increment(1., 0.);
    const demold::NewtonReport report = newton.solve(form);
    ASSERT_TRUE(report.converged) << report.reason;
    EXPECT_EQ(newton.largest_force, 0.); // the increment may yet be rejected
    form.accept();
    newton.accept(report);
    EXPECT_EQ(newton.largest_force, report.force);
    EXPECT_GT(report.force, 0.);
  }

  /// Entry @p i, known to every rank.
  double entry(const demold::Vector &v, const types::global_dof_index i)
  {
    return Utilities::MPI::sum(v.in_local_range(i) ||
                                   v.locally_owned_elements().is_element(i) ?
                                 static_cast<double>(v(i)) :
                                 0.,
                               MPI_COMM_WORLD);
  }
} // namespace

TEST(WeakForm, round_off_of_an_iteration_that_ran_away_excuses_nothing)
{
  const Block block;
  const auto  form = block.weak_form(true);
  form->setup();
  solve(*form);
  const auto measured = [&](const bool after_a_sound_one) {
    demold::ResidualMeasure measure;
    form->begin_increment(2., 0.);
    form->assemble(true, 0);
    if (after_a_sound_one)
      EXPECT_LT(measure(*form, 0., true), 1e-10);
    demold::Vector away = form->new_vector();
    away                = 1e14; // a translation, that strains the edges
    form->update(away, 1.);
    form->assemble(true, 1);
    const double result = measure(*form, 0., true);
    form->reject();
    return result;
  };
  EXPECT_EQ(measured(false), 0.);
  EXPECT_GT(measured(true), 1e-2);
}

TEST(WeakForm, multiplier_of_a_term_equals_the_reaction_of_a_support)
{
  const Block block;
  const auto  supported = block.weak_form(true);
  supported->setup();
  solve(*supported);

  const auto with_multiplier = block.weak_form(false);
  const bool here = block.dofs.locally_owned_dofs().is_element(block.corner);
  const unsigned int owner =
    Utilities::MPI::max(here ?
                          Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) :
                          0u,
                        MPI_COMM_WORLD);
  with_multiplier->add(std::make_unique<HeldUnknown>(block.corner, owner, .3));
  with_multiplier->setup();
  solve(*with_multiplier);

  const double reaction = entry(supported->force, block.corner);
  const double lambda   = entry(with_multiplier->accepted, block.dofs.n_dofs());
  EXPECT_GT(reaction, .01);
  EXPECT_NEAR(lambda, -reaction, 1e-9 * reaction);
  for (types::global_dof_index i = 0; i < block.dofs.n_dofs(); ++i)
    EXPECT_NEAR(entry(with_multiplier->accepted, i),
                entry(supported->accepted, i),
                1e-10);
}
