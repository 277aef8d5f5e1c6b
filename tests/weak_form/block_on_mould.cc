// SPDX-License-Identifier: LGPL-2.1-or-later
// A small block of rubber on a mould or on another block, ready to be solved.
#include "weak_form/block_on_mould.h"

#include "contact/node_to_segment.h"
#include "mortar/mortar_term.h"
#include "solid/dead_traction.h"
#include "solid/finite_strain_solid.h"
#include "solid/lumped_mass.h"
#include "test_rubber.h"
#include "weak_form/displacement_space.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>

#include <random>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    enum Boundary : types::boundary_id
    {
      other,
      slave,
      top,
      master,
      ground
    };

    constexpr double density = 1.12e-9; // [t/mm^3]

    RubberLaw rubber(const bool viscous)
    {
      return viscous ? test_rubber({{.3, .5}, {.2, 5.}}) : test_rubber();
    }
  } // namespace

  struct BlockOnMould::Mesh
  {
    explicit Mesh(const bool with_base)
      : triangulation(MPI_COMM_WORLD,
                      Triangulation<2>::none,
                      false,
                      parallel::shared::Triangulation<2>::partition_metis)
      , fe(FE_Q<2>(1), 2)
      , dofs(triangulation)
    {
      Triangulation<2> block, base;
      GridGenerator::subdivided_hyper_rectangle(block,
                                                {4, 3},
                                                Point<2>(0., 0.),
                                                Point<2>(2., 1.));
      GridGenerator::subdivided_hyper_rectangle(base,
                                                {5, 2},
                                                Point<2>(-1., -1.),
                                                Point<2>(3., 0.));
      if (with_base)
        GridGenerator::merge_triangulations(block, base, triangulation);
      else
        triangulation.copy_triangulation(block);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const double y     = cell->face(f)->center()[1];
              const bool   above = cell->center()[1] > 0.;
              const auto   is_at = [y](const double height) {
                return std::abs(y - height) < 1e-10;
              };
              cell->face(f)->set_boundary_id(is_at(0.) ?
                                               (above ? slave : master) :
                                             is_at(1.)  ? top :
                                             is_at(-1.) ? ground :
                                                          other);
            }
      dofs.distribute_dofs(fe);
    }

    parallel::shared::Triangulation<2> triangulation;
    FESystem<2>                        fe;
    DoFHandler<2>                      dofs;
  };

  namespace
  {
    /// Supports at all nodes of the ground and, where it moves, of the top.
    Supports supports(const DoFHandler<2> &dofs, const BlockOptions &options)
    {
      Supports                                               result;
      std::vector<std::pair<dealii::Point<3>, unsigned int>> places;
      const auto hold = [&](const Boundary id) {
        for (const auto &node : extract_surface<2>(dofs, {id}).nodes)
          for (unsigned int d = 0; d < 2; ++d)
            {
              result.unknowns.push_back(node.unknowns[d]);
              places.emplace_back(node.X, d);
            }
      };
      const auto motion = options.top;
      if (motion)
        hold(top);
      if (options.on_block)
        hold(ground);
      result.values = [places, motion](const double         t,
                                       std::vector<double> &values) {
        for (std::size_t k = 0; k < values.size(); ++k)
          values[k] = places[k].first[1] < 0. ?
                        0. :
                        motion(places[k].first, t)[places[k].second];
      };
      return result;
    }

    Master rigid_line(const RigidMotion &motion)
    {
      std::vector<Facet>            facets;
      std::vector<dealii::Point<3>> vertices;
      const unsigned int            n = 11;
      for (unsigned int i = 0; i <= n; ++i)
        vertices.emplace_back(-3. + 8. * i / n, 0., 0.);
      for (unsigned int i = 0; i < n; ++i)
        facets.push_back({{{i + 1, i, 0, 0}}, 2});
      return Master::rigid(facets, vertices, motion);
    }
  } // namespace

  namespace
  {
    std::unique_ptr<InterfaceTerm> make_contact(const DoFHandler<2> &dofs,
                                                const BlockOptions  &options,
                                                const Supports      &held)
    {
      BoundarySurface rubber = extract_surface<2>(dofs, {slave});
      Master          other  = options.on_block ?
                                 Master::deformable(extract_surface<2>(dofs, {master})) :
                                 rigid_line(options.mould);
      if (options.mortar)
        return std::make_unique<MortarTerm>(
          std::move(rubber),
          std::move(other),
          *options.interface,
          dofs.locally_owned_dofs(),
          [&held](const types::global_dof_index i) {
            return std::find(held.unknowns.begin(), held.unknowns.end(), i) !=
                   held.unknowns.end();
          },
          MPI_COMM_WORLD);
      return std::make_unique<NodeToSegment>(std::move(rubber),
                                             std::move(other),
                                             *options.interface,
                                             dofs.locally_owned_dofs(),
                                             MPI_COMM_WORLD);
    }
  } // namespace

  BlockOnMould::BlockOnMould(const BlockOptions &options)
    : options(options)
    , mesh(std::make_unique<Mesh>(options.on_block))
  {
    const DoFHandler<2> &dofs = mesh->dofs;
    form = std::make_unique<WeakForm>(displacement_space<2>(dofs),
                                      supports(dofs, options));

    SolidDescription solid;
    const bool       viscous = options.viscous;
    solid.law = [viscous](const dealii::Point<3> &) { return rubber(viscous); };
    form->add(make_solid_term<2>(dofs, solid));
    if (options.traction)
      form->add(
        make_dead_traction<2>(dofs, top, options.traction, PlaneModel()));
    if (options.interface)
      {
        auto term = make_contact(dofs, options, supports(dofs, options));
        contact   = term.get();
        form->add(std::move(term));
      }
    form->setup();
    if (options.integrator)
      {
        inertia = static_cast<Inertia *>(&form->add(std::make_unique<Inertia>(
          lumped_mass<2>(dofs, PlaneModel(), density, form->trial),
          *options.integrator,
          1.)));
        form->set_bulk_weight(1. - options.integrator->alpha_f());
      }

    LinearSolverParameters linear;
    linear.linear = "direct";
    solver        = std::make_unique<LinearSolver>(linear, MPI_COMM_WORLD);
    NewtonParameters parameters;
    parameters.residual_tolerance = options.residual_tolerance;
    newton = std::make_unique<Newton>(parameters, *solver);
  }

  BlockOnMould::~BlockOnMould() = default;

  NewtonReport BlockOnMould::solve(const double time)
  {
    form->begin_increment(time, 0.);
    const NewtonReport report = newton->solve(*form);
    if (inertia != nullptr)
      inertia->account_damping(*form);
    return report;
  }

  NewtonReport BlockOnMould::advance(const double time)
  {
    const NewtonReport report = solve(time);
    form->accept();
    newton->accept(report);
    if (inertia != nullptr && contact != nullptr)
      inertia->close(contact->closed_points());
    return report;
  }

  NewtonReport BlockOnMould::try_and_reject(const double time)
  {
    const NewtonReport report = solve(time);
    form->reject();
    return report;
  }

  void BlockOnMould::assemble_noise(const double time, const double amplitude)
  {
    form->begin_increment(time, 1.);
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> noise(-amplitude, amplitude);
    Vector                                 du = form->new_vector();
    for (const auto i : du.locally_owned_elements())
      du(i) = noise(generator);
    du.compress(VectorOperation::insert);
    for (unsigned int iteration = 0; iteration < 2; ++iteration)
      {
        form->update(du, 1.);
        form->assemble(true, iteration);
      }
    if (inertia != nullptr)
      inertia->account_damping(*form);
  }

  std::string BlockOnMould::saved() const
  {
    std::ostringstream out;
    form->save(out);
    return out.str();
  }

  void BlockOnMould::load(const std::string &state)
  {
    std::istringstream in(state);
    form->load(in);
  }

  void BlockOnMould::throw_with(const Tensor<1, 3> &v)
  {
    Vector velocity = form->new_vector(), acceleration = form->new_vector();
    for (unsigned int d = 0; d < 2; ++d)
      for (const auto i : DoFTools::extract_dofs(
             mesh->dofs,
             mesh->fe.component_mask(FEValuesExtractors::Scalar(d))))
        velocity(i) = v[d];
    velocity.compress(VectorOperation::insert);
    std::stringstream state;
    write_owned(state, velocity);
    write_owned(state, acceleration);
    write_values(state, {0., 0., 0.});
    inertia->load(state);
  }
} // namespace demold
