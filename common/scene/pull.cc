// SPDX-License-Identifier: LGPL-2.1-or-later
// How the mould moves: velocity, direction and tilt over time.
#include "scene/pull.h"

#include "base/parameter_error.h"
#include "scene/expression.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <memory>
#include <vector>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double degree = numbers::PI / 180.;

    std::vector<Expression> formulas(const std::string &list,
                                     const std::string &path)
    {
      std::vector<Expression> result;
      for (const auto &part : Utilities::split_string_list(list, ','))
        result.emplace_back(part, path);
      if (result.size() != 3)
        throw ExcParameter(path,
                           "needs three entries separated by commas; got " +
                             std::to_string(result.size()) + " in \"" + list +
                             "\".");
      return result;
    }

    /// Integral of @p f over [0, t], composite Simpson rule.
    template <typename Function>
    auto integral(const Function &f, const double t)
    {
      constexpr unsigned int n   = 200;
      auto                   sum = (f(0.) + f(t)) * (t / (6. * n));
      for (unsigned int i = 0; i < n; ++i)
        {
          sum += f((i + .5) * t / n) * (4. * t / (6. * n));
          if (i > 0)
            sum += f(i * t / n) * (2. * t / (6. * n));
        }
      return sum;
    }

    /// v(t) with the start-up ramp of a constant velocity.
    struct Velocity
    {
      explicit Velocity(const Pull &pull)
        : formula(pull.velocity, "Pull/velocity")
        , ramp(formula.is_number() ? pull.ramp : 0.)
      {}

      double operator()(const double t) const
      {
        return formula(t) * (ramp > 0. ? std::min(t / ramp, 1.) : 1.);
      }

      double travel(const double t) const
      {
        if (!formula.is_number())
          return integral([&](const double s) { return std::abs((*this)(s)); },
                          t);
        const double v = std::abs(formula(0.));
        return t < ramp ? .5 * v * t * t / ramp : v * (t - .5 * ramp);
      }

      Expression   formula;
      const double ramp;
    };

    /// Direction of travel at a time, unit length.
    struct Direction
    {
      Direction(const Pull &pull, const int dim)
        : dim(dim)
        , inclination(pull.inclination, "Pull/inclination")
      {
        if (pull.direction != "down")
          components = formulas(pull.direction, "Pull/direction");
      }

      bool is_constant() const
      {
        for (const Expression &c : components)
          if (!c.is_number())
            return false;
        return inclination.is_number();
      }

      Tensor<1, 3> operator()(const double t) const
      {
        Tensor<1, 3> d;
        if (components.empty())
          d[dim - 1] = -1.;
        else
          for (unsigned int i = 0; i < 3; ++i)
            d[i] = components[i](t);
        d /= std::max(d.norm(), 1e-300);
        const double angle = inclination(t) * degree;
        Tensor<1, 3> e_x;
        e_x[0]                  = 1.;
        const Tensor<1, 3> side = e_x - (e_x * d) * d;
        return std::cos(angle) * d +
               std::sin(angle) * side / std::max(side.norm(), 1e-300);
      }

      const int               dim;
      Expression              inclination;
      std::vector<Expression> components;
    };

    /// Rotation about z in 2-D, about y in 3-D: both turn +x towards the
    /// opening direction for positive angles.
    Tensor<2, 3> rotation(const int dim, const double angle)
    {
      Tensor<2, 3>       R;
      const unsigned int v = dim == 2 ? 1 : 2, axis = dim == 2 ? 2 : 1;
      R[axis][axis] = 1.;
      R[0][0] = R[v][v] = std::cos(angle);
      R[v][0]           = -std::sin(angle);
      R[0][v]           = std::sin(angle);
      return R;
    }
  } // namespace

  void Pull::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Pull");
    prm.add_parameter("velocity",
                      velocity,
                      "v velocity of the mould, number or formula in t [mm/s]");
    prm.add_parameter("ramp",
                      ramp,
                      "time in which a velocity given as a number builds up, "
                      "linearly [s]",
                      Patterns::Double(0.));
    prm.add_parameter("direction",
                      direction,
                      "of travel: down, or three formulas in t separated by "
                      "commas [-]");
    prm.add_parameter("inclination",
                      inclination,
                      "angle from the direction towards +x, number or formula "
                      "in t [degree]");
    prm.add_parameter("tilt",
                      tilt,
                      "rotation of the mould in the plane of x and the "
                      "vertical; a positive one lowers the side of +x; number "
                      "or formula in t [degree]");
    prm.add_parameter("tilt centre",
                      tilt_centre,
                      "point about which the mould turns [mm]");
    prm.add_parameter("opening",
                      opening,
                      "travel at which the run ends at the latest [mm]",
                      Patterns::Double(1e-9));
    prm.add_parameter("travel after release",
                      after,
                      "the run ends when the mould has travelled this far "
                      "since the last bond or touch [mm]",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }

  void Pull::check(const int dim) const
  {
    motion(dim);
    duration();
  }

  RigidMotion Pull::motion(const int dim) const
  {
    struct Parts
    {
      Velocity                velocity;
      Direction               direction;
      Expression              tilt;
      std::vector<Expression> centre;
    };
    const auto parts =
      std::make_shared<Parts>(Parts{Velocity(*this),
                                    Direction(*this, dim),
                                    Expression(tilt, "Pull/tilt"),
                                    formulas(tilt_centre, "Pull/tilt centre")});
    const Point<3> centre(parts->centre[0](0.),
                          parts->centre[1](0.),
                          parts->centre[2](0.));
    return [parts, centre, dim](const double t) {
      RigidPlacement placement;
      placement.centre = centre;
      if (parts->direction.is_constant() && parts->velocity.formula.is_number())
        placement.translation = parts->velocity.travel(t) *
                                (parts->velocity.formula(0.) < 0. ? -1. : 1.) *
                                parts->direction(0.);
      else
        placement.translation = integral(
          [&](const double s) {
            return parts->velocity(s) * parts->direction(s);
          },
          t);
      placement.rotation = rotation(dim, parts->tilt(t) * degree);
      return placement;
    };
  }

  double Pull::travel(const double t) const
  {
    return Velocity(*this).travel(t);
  }

  double Pull::duration() const
  {
    const Velocity v(*this);
    if (v.formula.is_number())
      {
        const double speed = std::abs(v.formula(0.));
        if (speed == 0.)
          throw ExcParameter("Pull/velocity",
                             "must not be 0 mm/s: the opening of " +
                               std::to_string(opening) +
                               " mm would never be reached; got 0.");
        const double in_ramp = .5 * speed * ramp;
        return opening < in_ramp ? std::sqrt(2. * opening * ramp / speed) :
                                   opening / speed + .5 * ramp;
      }
    double before = 0., after_ = 1e-6;
    while (v.travel(after_) < opening)
      {
        before = after_;
        after_ *= 2.;
        if (after_ > 1e9)
          throw ExcParameter("Pull/velocity",
                             "never travels the opening of " +
                               std::to_string(opening) + " mm; got \"" +
                               velocity + "\". Lower Pull/opening.");
      }
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle                            = .5 * (before + after_);
        (v.travel(middle) < opening ? before : after_) = middle;
      }
    return after_;
  }

  Tensor<1, 3> Pull::opening_direction(const int dim, const double t) const
  {
    return Direction(*this, dim)(t);
  }
} // namespace demold
