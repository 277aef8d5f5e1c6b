// SPDX-License-Identifier: LGPL-2.1-or-later
// What holds the back of a tread block.
#include "scene/fixing.h"

#include "base/parameter_error.h"
#include "geometry/boundary_names.h"
#include "material/elastic_rubber.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <sstream>

namespace demold
{
  using dealii::ParameterHandler;

  void Fixing::add_parameters(ParameterHandler &prm)
  {
    const dealii::Patterns::Double positive(1e-6, 1e6);
    prm.enter_subsection("Block");
    prm.add_parameter("fixing",
                      kind,
                      "what holds the back of block and base: rigid plate, or "
                      "a layer made by section Belt or Rubber base",
                      dealii::Patterns::Selection(
                        "rigid plate|belt plies|rubber base"));
    prm.leave_subsection();
    belt.add_parameters(prm);
    prm.enter_subsection("Rubber base");
    prm.add_parameter("thickness",
                      base_thickness,
                      "of the layer [mm]",
                      positive);
    prm.add_parameter("modulus",
                      base_modulus,
                      "E Young's modulus of the layer, elastic [MPa]",
                      positive);
    prm.add_parameter("bulk modulus",
                      base_bulk,
                      "K of the layer [MPa]",
                      positive);
    prm.leave_subsection();
  }

  void Fixing::check() const
  {
    if (kind == "belt plies")
      belt.check();
    if (kind == "rubber base" && !(3. * base_bulk > base_modulus))
      {
        std::ostringstream text;
        text << "must exceed a third of Rubber base/modulus = " << base_modulus
             << " MPa; got " << base_bulk
             << " MPa. Rubber has 10 to 1000 times "
             << "its modulus.";
        throw ExcParameter("Rubber base/bulk modulus", text.str());
      }
  }

  std::vector<double> Fixing::layers() const
  {
    if (kind == "belt plies")
      return std::vector<double>(belt.angles.size(), belt.ply.thickness);
    if (kind == "rubber base")
      return {base_thickness};
    return {};
  }

  RubberLaw Fixing::law(const unsigned int layer, const int dim) const
  {
    if (kind == "belt plies")
      return belt.law(layer, dim);
    return elastic_rubber(base_modulus, base_bulk);
  }

  template <int dim>
  std::vector<SupportRule> Fixing::supports() const
  {
    std::vector<SupportRule> rules;
    const auto hold = [&](const Boundary::Id id, const unsigned int component) {
      SupportRule rule;
      rule.boundary  = id;
      rule.component = component;
      rules.push_back(rule);
    };
    hold(Boundary::backing, dim - 1);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      if (kind == "belt plies")
        hold(d == 0 ? Boundary::layer_x : Boundary::layer_y, d);
      else
        hold(Boundary::backing, d);
    hold(Boundary::symmetry_x, 0);
    if (dim == 3)
      hold(Boundary::symmetry_y, 1);
    return rules;
  }

  template std::vector<SupportRule> Fixing::supports<2>() const;
  template std::vector<SupportRule> Fixing::supports<3>() const;
} // namespace demold
