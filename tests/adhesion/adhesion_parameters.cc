// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Adhesion makes the law it describes and explains what it rejects.
#include "adhesion/adhesion_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <functional>

namespace demold
{
  using namespace dealii;

  std::string complaint(const std::function<void(AdhesionParameters &)> &change)
  {
    AdhesionParameters parameters;
    parameters.law_name = "linear softening";
    change(parameters);
    try
      {
        parameters.check();
      }
    catch (const ExcParameter &error)
      {
        return error.what();
      }
    return "";
  }

  TEST(adhesion_parameters, defaults_are_valid_and_off)
  {
    AdhesionParameters parameters;
    EXPECT_FALSE(parameters.active());
    EXPECT_NO_THROW(parameters.check());
    EXPECT_EQ(complaint([](auto &) {}), "");
    EXPECT_EQ(complaint([](auto &p) { p.law_name = "exponential"; }), "");
    // Nothing is asked of entries that are not used.
    parameters.strength = -1.;
    EXPECT_NO_THROW(parameters.check());
  }

  TEST(adhesion_parameters, make_the_law_of_the_file)
  {
    ParameterHandler   prm;
    AdhesionParameters parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Adhesion\n"
                                "  set law = exponential\n"
                                "  set strength = 0.3\n"
                                "  set rupture gap = 0.04\n"
                                "  set penalty = 90\n"
                                "  set tangential coupling = 0.7\n"
                                "  set mixing = slip limit\n"
                                "  set unloading = plastic\n"
                                "  set friction weight = after rupture\n"
                                "  set readhesion pressure = 0.2\n"
                                "  set readhesion time = 3\n"
                                "  set readhesion efficiency = 0.1\n"
                                "end\n");
    parameters.check();
    const AdhesionLaw law       = parameters.law();
    const auto       &softening = std::get<ExponentialSoftening>(law.softening);
    EXPECT_EQ(softening.strength, .3);
    EXPECT_EQ(softening.gap, .04);
    EXPECT_EQ(softening.penalty, 90.);
    EXPECT_EQ(law.factors.a, .7);
    EXPECT_EQ(law.factors.b, 1.);
    EXPECT_EQ(law.unloading, AdhesionUnloading::plastic);
    EXPECT_EQ(law.friction, FrictionWeight::after_rupture);
    EXPECT_EQ(law.rest_pressure, .2);
    EXPECT_EQ(law.rest_time, 3.);
    EXPECT_EQ(law.rest_efficiency, .1);
  }

  TEST(adhesion_parameters, file_bounds_name_the_entry_they_reject)
  {
    for (const std::string entry :
         {"strength", "rupture gap", "penalty", "tangential coupling"})
      {
        ParameterHandler   prm;
        AdhesionParameters parameters;
        parameters.add_parameters(prm);
        try
          {
            prm.parse_input_from_string("subsection Adhesion\n  set " + entry +
                                        " = -1\nend\n");
            FAIL() << entry;
          }
        catch (const ExceptionBase &error)
          {
            EXPECT_NE(std::string(error.what()).find(entry), std::string::npos);
          }
      }
  }

  TEST(adhesion_parameters, penalty_must_be_steeper_than_the_softening)
  {
    EXPECT_EQ(complaint([](auto &p) { p.penalty = .4; }),
              "Adhesion/penalty: must exceed strength/rupture gap = 0.5 "
              "MPa/mm; got 0.4 MPa/mm. Take 20 to 100 times that, 10 to 50 "
              "MPa/mm, or raise the rupture gap.");
    EXPECT_NE(complaint([](auto &p) { p.penalty = .5; }), "");
    EXPECT_EQ(complaint([](auto &p) { p.penalty = .51; }), "");
    // A formulation without penalty does not care.
    AdhesionParameters parameters;
    parameters.law_name = "linear softening";
    parameters.penalty  = .4;
    EXPECT_NO_THROW(parameters.check_without_penalty());
  }

  TEST(adhesion_parameters, isotropic_mixing_needs_coupling_one)
  {
    EXPECT_EQ(complaint([](auto &p) { p.mixing = "isotropic"; }),
              "Adhesion/tangential coupling: must be 1 with mixing = "
              "isotropic, where it has no effect; got 0.5. Set it to 1, or "
              "choose mixing = energy, slip limit or proportional.");
    EXPECT_EQ(complaint([](auto &p) {
                p.mixing              = "isotropic";
                p.tangential_coupling = 1.;
              }),
              "");
  }

  TEST(adhesion_parameters, say_path_rule_number_and_remedy)
  {
    EXPECT_EQ(complaint([](auto &p) { p.strength = -.1; }),
              "Adhesion/strength: must be above 0 MPa; got -0.1 MPa. Choose "
              "law = none to simulate without adhesion.");
    EXPECT_EQ(complaint([](auto &p) { p.rupture_gap = 0.; }),
              "Adhesion/rupture gap: must be above 0 mm; got 0 mm. It is "
              "2 G_c/strength for linear softening and G_c/strength for "
              "exponential.");
    EXPECT_EQ(complaint([](auto &p) { p.mixing = "box"; }),
              "Adhesion/mixing: must be isotropic, slip limit, energy or "
              "proportional; got 'box'.");
    EXPECT_EQ(complaint([](auto &p) { p.law_name = "glue"; }),
              "Adhesion/law: must be one of none|linear softening|"
              "exponential; got 'glue'.");
    EXPECT_EQ(complaint([](auto &p) { p.unloading = "elastic"; }),
              "Adhesion/unloading: must be one of damage|plastic; got "
              "'elastic'.");
    EXPECT_EQ(complaint([](auto &p) { p.readhesion_efficiency = 2.; }),
              "Adhesion/readhesion efficiency: must be at most 1; got 2. A "
              "new bond is not stronger than the first.");
    EXPECT_EQ(complaint([](auto &p) { p.readhesion_time = -1.; }),
              "Adhesion/readhesion time: must be at least 0 s; got -1 s.");
    for (const double coupling : {0., -1.})
      EXPECT_EQ(complaint([&](auto &p) {
                  p.tangential_coupling = coupling;
                }).rfind("Adhesion/tangential coupling: must be above 0", 0),
                0u);
  }
} // namespace demold
