// SPDX-License-Identifier: LGPL-2.1-or-later
// The values one entry of a scene takes, and all runs several entries make.
#ifndef demold_study_sweep_h
#define demold_study_sweep_h

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// The parts of @p list between separators, trimmed; empty ones are left out.
  std::vector<std::string> split_list(const std::string &list,
                                      const char         separator);

  /// The first number in @p text: 0.1 of "0.1", 2 of "2, 8"; NaN of "q2".
  double first_number(const std::string &text);

  /// One section `Sweep N`.
  struct Sweep
  {
    std::string  section; ///< "Sweep 1"
    std::string  entry;   ///< "Body/fine size"; empty: not used
    std::string  list;    ///< values as written
    double       from   = 0.;
    double       to     = 0.;
    unsigned int number = 0;
    std::string  scale  = "logarithmic";
    std::string  label;
    std::string  symbol;
    unsigned int paired_with = 0;

    /// Declares the entries in the section that is open.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter for values that make no sense.
    void check() const;

    bool is_used() const;

    /// Heading of the column: `label` or the last part of `entry`.
    std::string heading() const;

    /// Name in formulas: `symbol` or the heading with '_' for what no name may
    /// contain.
    std::string name_in_formulas() const;

    /// As texts for `--set`: the list, or the range with six digits.
    std::vector<std::string> values() const;
  };

  /// One value for each sweep, in their order.
  using Combination = std::vector<std::string>;

  /// All combinations of the values of @p sweeps, the last sweep varying
  /// fastest; a sweep paired with another takes its values in step with it.
  /// A value may come again where a paired one differs. Throws ExcParameter if
  /// paired lists differ in length or a run would be made twice.
  std::vector<Combination> combinations(const std::vector<Sweep> &sweeps);

  /// "fine size = 0.1, element = q2".
  std::string combination_text(const std::vector<Sweep> &sweeps,
                               const Combination        &values);
} // namespace demold

#endif
