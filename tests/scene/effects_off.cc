// SPDX-License-Identifier: LGPL-2.1-or-later
// What a scene switches off costs nothing: no history, no CPU time.
#include "contact/node_to_segment.h"
#include "scene/scene_strategy.h"
#include "solid/finite_strain_solid.h"
#include "test_rubber.h"
#include "weak_form/displacement_space.h"

#include <deal.II/base/parameter_handler.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>

using namespace demold;

namespace
{
  constexpr dealii::types::boundary_id bottom = 2, top = 3;
  constexpr unsigned int               n_columns = 50, n_rows = 1;

  /// More CPU time than this share above a system without the effect is a cost.
  constexpr double tolerated = 1.02;

  /// A measurement is disturbed by others on the machine and by where the
  /// allocator happened to put things. One that finds a cost is repeated, with
  /// everything made anew, up to so many times. With eight processes on two
  /// cores most scatter by 1 %, few by more than 2 %; the cheapest effect,
  /// friction, takes 13 % here.
  constexpr unsigned int n_attempts = 5;

  /// Everything named and given its values, but nothing switched on.
  const std::string off = "subsection Material\n"
                          "  set viscosity        = false\n"
                          "  set relaxation times = 0.5, 5\n"
                          "  set branch moduli    = 0.9, 0.6\n"
                          "end\n"
                          "subsection Friction\n"
                          "  set coefficient = 0\n"
                          "  set penalty     = 40\n"
                          "end\n"
                          "subsection Adhesion\n"
                          "  set law         = none\n"
                          "  set strength    = 0.1\n"
                          "  set rupture gap = 0.2\n"
                          "end\n"
                          "subsection Solution\n"
                          "  set strategy   = quasi-static\n"
                          "  set integrator = bossak\n"
                          "end\n";

  struct Switch
  {
    std::string name, entry; ///< entry: what switches it on, on top of `off`
  };

  const std::vector<Switch> effects = {
    {"viscosity", "subsection Material\nset viscosity = true\nend\n"},
    {"friction", "subsection Friction\nset coefficient = 0.5\nend\n"},
    {"adhesion", "subsection Adhesion\nset law = linear softening\nend\n"},
    {"inertia", "subsection Solution\nset strategy = dynamics\nend\n"}};

  const std::string no_contact =
    "subsection Contact\nset formulation = none\nend\n";

  void make_strip(dealii::Triangulation<2> &mesh)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh,
      {n_columns, n_rows},
      dealii::Point<2>(0., 0.),
      dealii::Point<2>(n_columns, n_rows),
      true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
  }

  /// A strip of rubber on a flat mould, held at its top. It is so thin that
  /// what happens at the interface shows beside what happens inside.
  Scene<2> strip()
  {
    RigidSurface plane;
    plane.vertices = {dealii::Point<3>(n_columns + 1., 0., 0.),
                      dealii::Point<3>(-1., 0., 0.)};
    plane.facets   = {{{{0, 1, 0, 0}}, 2}};
    plane.patch    = {0};
    Scene<2> scene;
    scene.make_mesh = make_strip;
    scene.slave     = {bottom};
    scene.mould     = plane;
    scene.motion    = [](double) { return RigidPlacement(); };
    for (unsigned int d = 0; d < 2; ++d)
      {
        SupportRule rule;
        rule.boundary  = top;
        rule.component = d;
        scene.supports.push_back(rule);
      }
    return scene;
  }

  SceneParameters parsed(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    SceneParameters          parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string(entries);
    parameters.check();
    return parameters;
  }

  /// The strip as a run sets it up, strategy included.
  struct PreparedScene
  {
    explicit PreparedScene(const std::string &entries)
      : parameters(parsed(entries))
      , scene(strip())
      , system(scene, parameters, MPI_COMM_WORLD)
      , linear_solver(parameters.linear_solver, MPI_COMM_WORLD)
      , newton(make_nonlinear_solver(parameters.newton, linear_solver))
      , strategy(make_strategy(scene,
                               parameters,
                               system,
                               {*system.weak_form,
                                *newton,
                                linear_solver,
                                scene.end_time,
                                [](const std::string &) {}},
                               state))
    {}

    WeakForm &form()
    {
      return *system.weak_form;
    }

    const SceneParameters            parameters;
    const Scene<2>                   scene;
    SceneSystem<2>                   system;
    LinearSolver                     linear_solver;
    std::unique_ptr<NonlinearSolver> newton;
    IncrementState                   state;
    Strategy                         strategy;
  };

  /// The same strip put together by hand from an elastic solid and a contact
  /// term that has never heard of an effect.
  struct BareStrip
  {
    BareStrip()
      : mesh(MPI_COMM_WORLD,
             dealii::Triangulation<2>::none,
             false,
             dealii::parallel::shared::Triangulation<2>::partition_metis)
      , fe(dealii::FE_Q<2>(1), 2)
      , dofs(mesh)
    {
      make_strip(mesh);
      dofs.distribute_dofs(fe);
      const Scene<2> scene = strip();
      supports             = std::make_unique<SceneSupports>(
        collect_supports<2>(dofs, scene.supports));
      weak_form = std::make_unique<WeakForm>(displacement_space<2>(dofs),
                                             supports->supports());
      SolidDescription solid;
      solid.law = [](const dealii::Point<3> &) { return test_rubber(); };
      weak_form->add(make_solid_term<2>(dofs, solid));
      std::vector<Facet> facets;
      for (const auto &facet : scene.mould->facets)
        facets.push_back({facet.v, facet.n});
      weak_form->add(std::make_unique<NodeToSegment>(
        extract_surface<2>(dofs, scene.slave),
        Master::rigid(facets, scene.mould->vertices, scene.motion),
        InterfaceDescription(),
        dofs.locally_owned_dofs(),
        MPI_COMM_WORLD));
      weak_form->setup();
    }

    WeakForm &form()
    {
      return *weak_form;
    }

    dealii::parallel::shared::Triangulation<2> mesh;
    const dealii::FESystem<2>                  fe;
    dealii::DoFHandler<2>                      dofs;
    std::unique_ptr<SceneSupports>             supports;
    std::unique_ptr<WeakForm>                  weak_form;
  };

  std::vector<std::string> term_names(const WeakForm &form)
  {
    std::vector<std::string> names;
    for (const auto &term : form.term_list())
      names.push_back(term->name());
    return names;
  }

  std::size_t history_bytes(const WeakForm &form)
  {
    std::size_t bytes = 0;
    for (const auto &term : form.term_list())
      bytes += term->history_bytes();
    return bytes;
  }

  double cpu_seconds()
  {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
  }

  /// CPU time [s] of an increment of two assemblies: all that terms can cost.
  double cost_of_increment(WeakForm &form)
  {
    const double start = cpu_seconds();
    form.begin_increment(form.time() + 1e-3, 0.);
    EXPECT_TRUE(form.assemble(true, 0));
    EXPECT_TRUE(form.assemble(false, 1));
    form.accept();
    return cpu_seconds() - start;
  }

  /// Cost of the strip with @p entries over that of the bare one: the smallest
  /// of 100 short increments each, turn by turn.
  double cost_ratio(const std::string &entries)
  {
    PreparedScene    prepared(entries);
    BareStrip        bare;
    constexpr double never = std::numeric_limits<double>::max();
    double           tried = never, reference = never;
    for (unsigned int k = 0; k < 100; ++k)
      {
        tried     = std::min(tried, cost_of_increment(prepared.form()));
        reference = std::min(reference, cost_of_increment(bare.form()));
      }
    EXPECT_EQ(prepared.form().n_unknowns(), bare.form().n_unknowns());
    return tried / reference;
  }

  testing::AssertionResult costs_nothing(const std::string &entries)
  {
    std::vector<double> ratios;
    for (unsigned int k = 0; k < n_attempts; ++k)
      {
        ratios.push_back(cost_ratio(entries));
        if (ratios.back() <= tolerated)
          return testing::AssertionSuccess()
                 << "CPU times over those of the bare strip: "
                 << testing::PrintToString(ratios);
      }
    return testing::AssertionFailure()
           << "CPU times over those of the bare strip: "
           << testing::PrintToString(ratios);
  }

  /// Median of all attempts: one that the machine has disturbed says nothing.
  double usual_cost_ratio(const std::string &entries)
  {
    std::vector<double> ratios;
    for (unsigned int k = 0; k < n_attempts; ++k)
      ratios.push_back(cost_ratio(entries));
    const auto middle = ratios.begin() + n_attempts / 2;
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
  }
} // namespace

TEST(EffectsOff, leave_an_elastic_solid_without_contact_without_history)
{
  PreparedScene prepared(off + no_contact);
  EXPECT_EQ(term_names(prepared.form()), std::vector<std::string>{"solid"});
  EXPECT_EQ(history_bytes(prepared.form()), 0u);
}

TEST(EffectsOff, leave_contact_its_own_history_and_nothing_else)
{
  PreparedScene prepared(off);
  EXPECT_EQ(term_names(prepared.form()),
            (std::vector<std::string>{"solid", "contact"}));
  EXPECT_EQ(prepared.system.interface->sums().points, n_columns + 1);
  EXPECT_EQ(history_bytes(prepared.form()),
            2 * (n_columns + 1) * sizeof(ContactHistory));
}

TEST(EffectsOff, are_seen_by_their_history_when_switched_on)
{
  PreparedScene without(off);
  for (const Switch &effect : effects)
    {
      PreparedScene with(off + effect.entry);
      EXPECT_GT(history_bytes(with.form()), history_bytes(without.form()))
        << effect.name;
    }
}

TEST(EffectsOff, cost_no_cpu_time)
{
  EXPECT_TRUE(costs_nothing(off));
}

// The same measurement finds every effect that works: it can fail.
TEST(EffectsOff, are_seen_by_their_cpu_time_when_switched_on)
{
  for (const Switch &effect : effects)
    EXPECT_GT(usual_cost_ratio(off + effect.entry), tolerated) << effect.name;
}
