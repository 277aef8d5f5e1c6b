// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Supports: what is held, what is driven, what is loaded.
#include "scene/support_entries.h"

#include "base/parameter_error.h"
#include "geometry/boundary_names.h"
#include "scene/expression.h"
#include "scene/vector_of_time.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <memory>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Boundary and components of one item of a list.
    struct Item
    {
      std::string               boundary;
      std::vector<unsigned int> components;
    };

    Item parse_item(const std::string &item,
                    const std::string &path,
                    const unsigned int dim)
    {
      const auto space = item.rfind(' ');
      if (space == std::string::npos)
        throw ExcParameter(path,
                           "needs a boundary and components, such as top "
                           "xy; got \"" +
                             item + "\".");
      Item result{item.substr(0, space), {}};
      for (const char c : item.substr(space + 1))
        {
          const unsigned int d = c - 'x';
          if (d >= dim)
            throw ExcParameter(path,
                               std::string("knows the components ") +
                                 (dim == 2 ? "x, y" : "x, y, z") +
                                 " in this dimension; got \"" + c + "\" in \"" +
                                 item + "\".");
          result.components.push_back(d);
        }
      return result;
    }

    /// "top xy, left x" becomes one rule per component.
    std::vector<SupportRule> rules_of(const std::string &list,
                                      const std::string &path,
                                      const unsigned int dim)
    {
      std::vector<SupportRule> rules;
      for (const auto &text : Utilities::split_string_list(list, ','))
        {
          const Item item = parse_item(text, path, dim);
          for (const unsigned int d : item.components)
            {
              SupportRule rule;
              rule.component = d;
              if (item.boundary != "body")
                rule.boundary = boundary_id(item.boundary, path);
              rules.push_back(rule);
            }
        }
      return rules;
    }
  } // namespace

  void SupportEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Supports");
    prm.add_parameter("held",
                      held,
                      "boundary and components at rest, such as top xy, left "
                      "x; body: every node; auto: the top, unless something "
                      "is driven");
    prm.add_parameter("driven",
                      driven,
                      "boundary and components that follow the motion");
    prm.add_parameter(
      "driven where",
      driven_where,
      "formula in x, y, z at the start [mm]; driven are only "
      "nodes where it is positive: a small part of an edge lets "
      "it turn, all of it does not [-]");
    for (const int d : {0, 1, 2})
      prm.add_parameter(std::string("motion ") + "xyz"[d],
                        motion[d],
                        "displacement of driven nodes, formula in t and x, y, "
                        "z [mm]");
    prm.add_parameter("traction boundary",
                      traction_boundary,
                      "boundary with a dead load; empty: none");
    prm.add_parameter(
      "traction",
      traction,
      "dead load per reference area, three formulas in t [MPa]");
    prm.leave_subsection();
  }

  template <int dim>
  std::vector<SupportRule> SupportEntries::supports() const
  {
    std::vector<SupportRule> rules = rules_of(driven, "Supports/driven", dim);
    if (driven.empty() && driven_where != "1")
      throw ExcParameter("Supports/driven where",
                         "needs Supports/driven; got " + driven_where +
                           " and nothing that is driven.");
    const auto where =
      std::make_shared<Expression>(driven_where, "Supports/driven where");
    for (SupportRule &rule : rules)
      {
        if (!where->is_number() || (*where)(0.) <= 0.)
          rule.where = [where](const Point<3> &X) {
            return (*where)(0., X) > 0.;
          };
        const unsigned int d = rule.component;
        const auto         formula =
          std::make_shared<Expression>(motion[d],
                                       std::string("Supports/motion ") +
                                         "xyz"[d]);
        rule.value = [formula](const double t, const Point<3> &X) {
          return (*formula)(t, X);
        };
      }
    const std::string at_rest = held != "auto"  ? held :
                                !driven.empty() ? "" :
                                dim == 3        ? "top xyz" :
                                                  "top xy";
    for (const SupportRule &rule : rules_of(at_rest, "Supports/held", dim))
      rules.push_back(rule);
    return rules;
  }

  std::vector<TractionRule> SupportEntries::tractions() const
  {
    if (traction_boundary.empty())
      return {};
    return {{boundary_id(traction_boundary, "Supports/traction boundary"),
             vector_of_time(traction, "Supports/traction")}};
  }

  template std::vector<SupportRule> SupportEntries::supports<2>() const;
  template std::vector<SupportRule> SupportEntries::supports<3>() const;
} // namespace demold
