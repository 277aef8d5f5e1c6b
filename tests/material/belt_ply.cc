// SPDX-License-Identifier: LGPL-2.1-or-later
// Plies have the constants of theory A.5, their law derivatives of one energy.
#include "material/belt_ply.h"

#include "base/parameter_error.h"
#include "material/ply_constants.h"
#include "material/ply_parameters.h"
#include "random_deformation.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <Sacado.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace demold;

namespace
{
  constexpr double degree = dealii::numbers::PI / 180.;

  /// The two cords of theory A.5 in rubber of 6 MPa.
  CordRubber steel(const double area, const double spacing, const double h)
  {
    return {172200., .3, 6., .49, area / (spacing * h)};
  }

  const CordRubber thick_cord = steel(.212, 1.16, 1.2);
  const CordRubber thin_cord  = steel(.141, 1.25, 1.1);

  void expect_near_one_percent(const double computed, const double theory)
  {
    EXPECT_NEAR(computed, theory, .01 * theory);
  }

  /// Matrix and families of cords at the given angles in the plane 1, 2.
  BeltPly ply_of(const MooneyRivlin        &matrix,
                 const double               stiffness,
                 const std::vector<double> &degrees)
  {
    BeltPly ply;
    ply.matrix = matrix;
    for (const double angle : degrees)
      {
        const double c = std::cos(angle * degree), s = std::sin(angle * degree);
        ply.fibres.push_back({{{c, s, 0.}}, stiffness, .01});
      }
    return ply;
  }

  RubberLaw law_of(const BeltPly &ply)
  {
    RubberLaw law;
    law.elastic = ply;
    return law;
  }

  BulkResponse answer(const RubberLaw &law, const SymmetricTensor<2, 3> &C)
  {
    BulkResponse response;
    law.evaluate(C, 0., nullptr, nullptr, true, response);
    return response;
  }

  const BeltPly skew_ply = ply_of({98.7, 2.7, .4}, 3000., {20., -35.});
} // namespace

TEST(ply_constants, are_those_of_theory_within_one_percent)
{
  expect_near_one_percent(thick_cord.volume_fraction, .152);
  const auto ht = ply_constants(PlyRule::halpin_tsai, thick_cord);
  const auto gt = ply_constants(PlyRule::gough_tangorra, thick_cord);
  const auto ah = ply_constants(PlyRule::akasaka_hirano, thick_cord);
  for (const PlyConstants &ply : {ht, gt, ah})
    expect_near_one_percent(ply.E1, 26200.);
  expect_near_one_percent(ht.E2, 9.23);
  expect_near_one_percent(gt.E2, 6.78);
  expect_near_one_percent(ah.E2, 8.);
  expect_near_one_percent(ht.G12, 2.74);
  expect_near_one_percent(gt.G12, 1.70);
  expect_near_one_percent(ah.G12, 2.);
  expect_near_one_percent(ht.nu12, .46);

  expect_near_one_percent(thin_cord.volume_fraction, .1025);
  const auto thin = ply_constants(PlyRule::halpin_tsai, thin_cord);
  expect_near_one_percent(thin.E1, 17700.);
  expect_near_one_percent(thin.E2, 8.06);
  expect_near_one_percent(thin.G12, 2.47);
}

TEST(balanced_pair, has_the_constants_of_theory_within_one_percent)
{
  const auto thick =
    balanced_pair(ply_constants(PlyRule::akasaka_hirano, thick_cord),
                  20. * degree);
  expect_near_one_percent(thick.E_x, 395.);
  expect_near_one_percent(thick.E_y, 7.1);
  expect_near_one_percent(thick.G_xy, 2700.);
  const auto thin =
    balanced_pair(ply_constants(PlyRule::akasaka_hirano, thin_cord),
                  20. * degree);
  expect_near_one_percent(thin.E_x, 391.);
  expect_near_one_percent(thin.E_y, 7.1);
  expect_near_one_percent(thin.G_xy, 1825.);
}

// The constants of Akasaka and Hirano are the formula's: E2 = 4 E_r/3 = 4 G_r
// of incompressible rubber; the formula leaves out terms of E2/E1.
TEST(balanced_pair, of_inextensible_cords_is_akasakas_closed_form)
{
  CordRubber parts     = thick_cord;
  parts.rubber_poisson = .5;
  for (const double angle : {0., 10., 20., 45., 70., 90.})
    {
      const auto pair =
        balanced_pair(ply_constants(PlyRule::akasaka_hirano, parts),
                      angle * degree);
      const auto closed = akasaka_pair(parts, angle * degree);
      EXPECT_NEAR(pair.E_x, closed.E_x, .002 * closed.E_x) << angle;
      EXPECT_NEAR(pair.E_y, closed.E_y, .002 * closed.E_y) << angle;
      EXPECT_NEAR(pair.G_xy, closed.G_xy, .002 * closed.G_xy) << angle;
    }
}

// eta -> 1 for steel in rubber: theory A.5.
TEST(halpin_tsai, tends_to_its_limit_for_rigid_cords)
{
  CordRubber parts   = thick_cord;
  parts.cord_modulus = 1e12;
  const double V     = parts.volume_fraction;
  const auto   ply   = ply_constants(PlyRule::halpin_tsai, parts);
  EXPECT_NEAR(ply.E2, 6. * (1. + 2. * V) / (1. - V), 1e-8);
  EXPECT_NEAR(ply.G12,
              parts.rubber_shear_modulus() * (1. + V) / (1. - V),
              1e-8);
}

TEST(halpin_tsai, of_no_cords_is_the_rubber_and_of_cords_alone_the_cord)
{
  CordRubber parts      = thick_cord;
  parts.volume_fraction = 0.;
  auto ply              = ply_constants(PlyRule::halpin_tsai, parts);
  EXPECT_DOUBLE_EQ(ply.E1, 6.);
  EXPECT_DOUBLE_EQ(ply.E2, 6.);
  EXPECT_DOUBLE_EQ(ply.G12, 6. / 2.98);
  parts.volume_fraction = 1.;
  ply                   = ply_constants(PlyRule::halpin_tsai, parts);
  EXPECT_NEAR(ply.E2, 172200., 1e-6);
  EXPECT_NEAR(ply.G12, 172200. / 2.6, 1e-6);
}

// The energy of any strain is the same in the axes of ply and laminate.
TEST(off_axis_stiffness, keeps_the_energy_of_every_strain)
{
  const PlyConstants ply{100., 8., 3., .4};
  const auto         own = off_axis(ply, 0.);
  EXPECT_NEAR(own.Q16, 0., 1e-14);
  EXPECT_NEAR(own.Q26, 0., 1e-14);
  const auto energy = [](const PlaneStiffness       &Q,
                         const dealii::Tensor<2, 2> &e) {
    const double g = 2. * e[0][1];
    return .5 * (Q.Q11 * e[0][0] * e[0][0] + Q.Q22 * e[1][1] * e[1][1] +
                 Q.Q66 * g * g) +
           Q.Q12 * e[0][0] * e[1][1] + Q.Q16 * e[0][0] * g +
           Q.Q26 * e[1][1] * g;
  };
  for (const double angle : {.3, -.9, 1.4})
    {
      const double         c = std::cos(angle), s = std::sin(angle);
      dealii::Tensor<2, 2> R; // to the axes of the ply
      R[0][0] = R[1][1] = c;
      R[0][1]           = s;
      R[1][0]           = -s;
      dealii::Tensor<2, 2> e;
      e[0][0] = .01;
      e[1][1] = -.03;
      e[0][1] = e[1][0] = .02;
      EXPECT_NEAR(energy(off_axis(ply, angle), e),
                  energy(own, R * e * dealii::transpose(R)),
                  1e-15);
    }
}

// W written down once more and differentiated automatically, twice.
TEST(belt_ply, has_the_stress_and_tangent_that_sacado_makes_of_its_energy)
{
  using Inner                      = Sacado::Fad::SFad<double, 6>;
  using Number                     = Sacado::Fad::SFad<Inner, 6>;
  constexpr unsigned int rows[]    = {0, 1, 2, 0, 0, 1},
                         columns[] = {0, 1, 2, 1, 2, 2};

  std::mt19937 generator(4);
  unsigned int n_stretched = 0, n_compressed = 0;
  for (unsigned int sample = 0; sample < 40; ++sample)
    {
      const auto C_given = right_cauchy_green(random_gradient(generator, .3));
      Number     C[3][3];
      for (unsigned int k = 0; k < 6; ++k)
        C[rows[k]][columns[k]] = C[columns[k]][rows[k]] =
          Number(6, k, Inner(6, k, C_given[rows[k]][columns[k]]));

      const MooneyRivlin &m  = skew_ply.matrix;
      Number              I1 = C[0][0] + C[1][1] + C[2][2], CC = 0.;
      for (unsigned int k = 0; k < 9; ++k)
        CC += C[k / 3][k % 3] * C[k / 3][k % 3];
      const Number I2  = .5 * (I1 * I1 - CC);
      const Number III = C[0][0] * (C[1][1] * C[2][2] - C[1][2] * C[2][1]) -
                         C[0][1] * (C[1][0] * C[2][2] - C[1][2] * C[2][0]) +
                         C[0][2] * (C[1][0] * C[2][1] - C[1][1] * C[2][0]);
      Number W = .5 * m.mu1 * (I1 - 3.) + .5 * m.mu2 * (I2 - 3.) +
                 .25 * m.lambda * (III - 1.) -
                 (.5 * m.lambda + m.mu1 + 2. * m.mu2) * .5 * log(III);
      for (const FibreFamily &f : skew_ply.fibres)
        {
          Number I4 = 0.;
          for (unsigned int k = 0; k < 9; ++k)
            I4 += f.direction[k / 3] * f.direction[k % 3] * C[k / 3][k % 3];
          const Number strain  = sqrt(I4) - 1.;
          const bool   tension = strain.val().val() >= 0.;
          (tension ? n_stretched : n_compressed) += 1;
          W += .5 * f.stiffness * (tension ? 1. : .01) * strain * strain;
        }

      const auto   response = answer(law_of(skew_ply), C_given);
      const double scale    = response.dS_dE.norm();
      EXPECT_NEAR(response.stored, W.val().val(), 1e-12 * scale);
      // dE_kl, k != l, counts twice in the derivative by the entry C_kl.
      const auto factor = [](const unsigned int k) { return k < 3 ? 2. : 1.; };
      for (unsigned int i = 0; i < 6; ++i)
        {
          EXPECT_NEAR(response.S[rows[i]][columns[i]],
                      factor(i) * W.dx(i).val(),
                      1e-12 * scale);
          for (unsigned int k = 0; k < 6; ++k)
            EXPECT_NEAR(
              response.dS_dE[rows[i]][columns[i]][rows[k]][columns[k]],
              factor(i) * factor(k) * W.dx(i).dx(k),
              1e-9 * scale);
        }
    }
  EXPECT_GE(n_stretched, 10u);
  EXPECT_GE(n_compressed, 10u);
}

TEST(belt_ply, has_a_symmetric_tangent)
{
  std::mt19937 generator(5);
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      const auto D = answer(law_of(skew_ply),
                            right_cauchy_green(random_gradient(generator, .3)))
                       .dS_dE;
      for (unsigned int k = 0; k < 81; ++k)
        EXPECT_EQ(D[k / 27][k / 9 % 3][k / 3 % 3][k % 3],
                  D[k / 3 % 3][k % 3][k / 27][k / 9 % 3]);
    }
}

// A rotation before the deformation turns cords and C alike; one after it
// leaves C, and so S, as they were.
TEST(belt_ply, answers_alike_in_every_frame)
{
  const double c = std::cos(.7), s = std::sin(.7);
  Tensor<2, 3> R;
  R[0][0] = R[1][1] = c;
  R[0][1]           = -s;
  R[1][0]           = s;
  R[2][2]           = 1.;
  BeltPly turned    = skew_ply;
  for (FibreFamily &f : turned.fibres)
    {
      const auto a = f.direction;
      f.direction  = {{c * a[0] - s * a[1], s * a[0] + c * a[1], a[2]}};
    }
  std::mt19937 generator(6);
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      const auto   F      = random_gradient(generator, .3);
      const auto   before = answer(law_of(skew_ply), right_cauchy_green(F));
      const auto   after  = answer(law_of(skew_ply), right_cauchy_green(R * F));
      const double scale  = before.dS_dE.norm();
      EXPECT_LT((before.S - after.S).norm(), 1e-12 * scale);
      EXPECT_NEAR(before.stored, after.stored, 1e-12 * scale);
      const auto other =
        answer(law_of(turned), right_cauchy_green(F * transpose(R)));
      EXPECT_LT((Tensor<2, 3>(other.S) -
                 R * Tensor<2, 3>(before.S) * transpose(R))
                  .norm(),
                1e-12 * scale);
      EXPECT_NEAR(other.stored, before.stored, 1e-12 * scale);
    }
}

// At small strain, free of stress across the laminate, the law of a pair is
// Akasaka's formula in the limit of incompressible rubber.
TEST(belt_ply, of_a_pair_starts_with_the_stiffness_of_akasaka)
{
  CordRubber parts     = thick_cord;
  parts.rubber_poisson = .5;
  const double  k      = parts.cord_modulus * parts.volume_fraction;
  const BeltPly pair   = ply_of({1e9, parts.rubber_shear_modulus(), 0.},
                              .5 * k, // each ply is half of the laminate
                              {20., -20.});
  const auto D = answer(law_of(pair), dealii::unit_symmetric_tensor<3>()).dS_dE;
  const auto plane = [&D](const unsigned int i, const unsigned int j) {
    return D[i][i][j][j] - D[i][i][2][2] * D[2][2][j][j] / D[2][2][2][2];
  };
  const auto closed = akasaka_pair(parts, 20. * degree);
  EXPECT_NEAR(plane(0, 0) - plane(0, 1) * plane(0, 1) / plane(1, 1),
              closed.E_x,
              1e-4 * closed.E_x);
  EXPECT_NEAR(plane(1, 1) - plane(0, 1) * plane(0, 1) / plane(0, 0),
              closed.E_y,
              1e-4 * closed.E_y);
  EXPECT_NEAR(D[0][1][0][1], closed.G_xy, 1e-9 * closed.G_xy);
}

// sigma = k (lambda - 1) of cords alone in uniaxial stretch (nominal).
TEST(cords, pull_by_their_stretch_and_push_a_hundredth_of_it)
{
  const BeltPly cords = ply_of({0., 0., 0.}, 500., {0.});
  for (const double stretch : {.7, .99, 1., 1.001, 1.4})
    {
      const auto   F        = stretches(stretch, 1., 1.);
      const auto   response = answer(law_of(cords), right_cauchy_green(F));
      const double k        = stretch < 1. ? 5. : 500.;
      EXPECT_NEAR(stretch * response.S[0][0], k * (stretch - 1.), 1e-12);
      EXPECT_NEAR(response.S[1][1], 0., 1e-12);
      EXPECT_NEAR(response.stored, .5 * k * std::pow(stretch - 1., 2), 1e-12);
    }
}

TEST(belt_ply, without_cords_is_its_rubber)
{
  std::mt19937 generator(8);
  RubberLaw    rubber;
  rubber.elastic = skew_ply.matrix;
  const auto C   = right_cauchy_green(random_gradient(generator, .3));
  const auto a   = answer(rubber, C),
             b   = answer(law_of(ply_of(skew_ply.matrix, 0., {})), C);
  EXPECT_EQ(a.S, b.S);
  EXPECT_EQ(a.dS_dE, b.dS_dE);
  EXPECT_EQ(a.stored, b.stored);
}

namespace
{
  BeltParameters parsed_belt(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    BeltParameters           belt;
    belt.add_parameters(prm);
    prm.parse_input_from_string("subsection Belt\n" + entries + "\nend\n");
    return belt;
  }

  std::string complaint(const std::string &entries)
  {
    try
      {
        parsed_belt(entries).check();
      }
    catch (const ExcParameter &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(belt, has_its_cords_in_the_plane_of_the_plies)
{
  const BeltParameters belt = parsed_belt("set angles = 30, -30");
  for (const int dim : {2, 3})
    for (const unsigned int number : {0u, 1u})
      {
        const auto law = std::get<BeltPly>(belt.law(number, dim).elastic);
        ASSERT_EQ(law.fibres.size(), 1u);
        const auto  &a       = law.fibres[0].direction;
        const double lateral = number == 0 ? .5 : -.5;
        EXPECT_NEAR(a[0], std::sqrt(.75), 1e-15);
        EXPECT_NEAR(a[dim == 3 ? 1 : 2], lateral, 1e-15);
        EXPECT_EQ(a[dim == 3 ? 2 : 1], 0.);
        expect_near_one_percent(law.fibres[0].stiffness, 26226.);
        // mu scaled by G12/G_r, bulk response that of the rubber
        expect_near_one_percent(law.matrix.mu1, 2.74);
        EXPECT_NEAR(law.matrix.lambda, 6. * .49 / (1.49 * .02), 1e-10);
      }
}

TEST(belt, refuses_cords_that_overlap_or_are_softer_than_rubber)
{
  EXPECT_EQ(complaint(""), "");
  // diameter of 0.212 mm^2: 0.52 mm
  for (const char *const entry : {"cord spacing", "ply thickness"})
    {
      const auto text = complaint("set " + std::string(entry) + " = 0.5");
      EXPECT_NE(text.find("Belt/" + std::string(entry)), std::string::npos);
      EXPECT_NE(text.find("0.51"), std::string::npos) << text;
      EXPECT_NE(text.find("got 0.5 mm"), std::string::npos) << text;
    }
  const auto text = complaint("set cord modulus = 5");
  EXPECT_NE(text.find("Belt/cord modulus: must exceed Belt/rubber modulus = 6"),
            std::string::npos)
    << text;
}
