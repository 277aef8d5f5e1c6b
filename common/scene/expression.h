// SPDX-License-Identifier: LGPL-2.1-or-later
// A number in a parameter file that may depend on time and position.
#ifndef demold_scene_expression_h
#define demold_scene_expression_h

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace demold
{
  /// A formula in t [s] and the reference position x, y, z [mm], with the
  /// functions of muParser (sin, exp, min, if(a, b, c), pi ...).
  class Expression
  {
  public:
    /// Throws ExcParameter with @p path if @p formula cannot be understood.
    Expression(const std::string &formula, const std::string &path);
    ~Expression();
    Expression(Expression &&) noexcept;

    double operator()(const double            t,
                      const dealii::Point<3> &X = dealii::Point<3>()) const;

    /// Is it one plain number?
    bool is_number() const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser;
  };
} // namespace demold

#endif
