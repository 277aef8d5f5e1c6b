// SPDX-License-Identifier: LGPL-2.1-or-later
// What a study file says: scene, sweeps, quantity, reference, refinement.
#ifndef demold_study_study_parameters_h
#define demold_study_study_parameters_h

#include "study/formula.h"
#include "study/sweep.h"

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Compare`: what is looked at, and against what.
  struct Comparison
  {
    std::string quantity  = "peak force [N]";
    std::string take      = "summary"; ///< or which row of a table
    std::string table     = "history.csv";
    std::string at_column = "opening [mm]";
    std::string at_value  = "0";
    std::string also; ///< further entries of summary.json
    std::string reference = "finest";
    std::string closed_form;
    std::string definitions;
    double      value     = 0.;
    std::string among     = "all runs";
    std::string measure   = "relative";
    double      round_off = 1e-12;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// "error [-]", or the unit of the quantity if it is absolute.
    std::string error_heading() const;

    /// Which number is compared, in words.
    std::string quantity_in_words() const;
  };

  /// The whole file.
  struct StudyParameters
  {
    static constexpr unsigned int max_sweeps = 4;

    std::string                   title;
    std::string                   scene;
    std::string                   step;
    std::string                   program; ///< instead of the step
    std::string                   settings;
    bool                          fields         = false;
    unsigned int                  runs_at_a_time = 1;
    std::array<Sweep, max_sweeps> all_sweeps;
    Comparison                    compare;
    unsigned int                  refined_sweep = 1;
    std::string                   finest        = "last value";

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter for entries that contradict each other.
    void check() const;

    /// Those with an entry.
    std::vector<Sweep> sweeps() const;

    /// Position in sweeps() of the refined one; sweeps().size() if none is.
    std::size_t refined() const;

    /// Does sweep @p s change along a series? The refined one does, and those
    /// paired with it; the others tell series apart.
    bool varies_in_series(const std::size_t s) const;

    /// What formulas may use in the run with these @p values.
    Symbols symbols(const Combination &values) const;

    /// (path, value) of `settings`. Throws ExcParameter.
    std::vector<std::pair<std::string, std::string>> fixed_settings() const;
  };
} // namespace demold

#endif
