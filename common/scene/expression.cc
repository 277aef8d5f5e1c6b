// SPDX-License-Identifier: LGPL-2.1-or-later
// A number in a parameter file that may depend on time and position.
#include "scene/expression.h"

#include "base/parameter_error.h"

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <cstdlib>

namespace demold
{
  using namespace dealii;

  struct Expression::Parser
  {
    FunctionParser<3> function;
    bool              number = false;
    double            value  = 0.;
  };

  Expression::Expression(const std::string &formula, const std::string &path)
    : parser(std::make_unique<Parser>())
  {
    char *end          = nullptr;
    parser->value      = std::strtod(formula.c_str(), &end);
    const bool nothing = end == formula.c_str();
    while (*end == ' ')
      ++end;
    parser->number = !nothing && *end == '\0';
    if (parser->number)
      return;
    try
      {
        parser->function.initialize("x,y,z,t",
                                    formula,
                                    {{"pi", numbers::PI}},
                                    true);
        (*this)(0.);
      }
    catch (const std::exception &)
      {
        throw ExcParameter(path,
                           "must be a number or a formula in x, y, z [mm] and "
                           "t [s], for example 50*min(t/0.005, 1); got \"" +
                             formula + "\".");
      }
  }

  Expression::~Expression()                      = default;
  Expression::Expression(Expression &&) noexcept = default;

  double Expression::operator()(const double t, const Point<3> &X) const
  {
    if (parser->number)
      return parser->value;
    parser->function.set_time(t);
    return parser->function.value(X);
  }

  bool Expression::is_number() const
  {
    return parser->number;
  }
} // namespace demold
