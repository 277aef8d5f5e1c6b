// SPDX-License-Identifier: LGPL-2.1-or-later
// Which Prony series a parameter file asks for, and how the best is chosen.
#ifndef demold_identification_prony_choice_h
#define demold_identification_prony_choice_h

#include "identification/prony_fit.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  struct ParameterInclude;

  /// Entries that fits in frequency and in time have in common.
  class PronyChoice
  {
  public:
    /// Declares the entries in the section @p name, which the caller has
    /// entered.
    void add_parameters(dealii::ParameterHandler &prm, const std::string &name);

    /// Throws ExcParameter where @p curves cannot determine what is asked for.
    void check(const std::vector<PronyCurve> &curves) const;

    /// A series that has been tried.
    struct Trial
    {
      unsigned int n_branches;
      unsigned int n_parameters; ///< that are not zero
      double       rms;          ///< weighted [-]
      double       criterion;    ///< PronyResult::criterion()
    };

    struct Outcome
    {
      PronyResult        best;
      std::vector<Trial> trials;
    };

    /// The series asked for: of the given times or number of branches, else of
    /// the number with the smallest criterion. @p equilibrium as in PronyFit.
    Outcome fit(const std::vector<PronyCurve> &curves,
                const std::vector<double>     &equilibrium) const;

    /// A sentence for the preview.
    std::string in_words() const;

    double weight(double value) const; ///< of a datum [MPa]: [1/MPa]

    bool relative() const
    {
      return weights == "relative";
    }

    /// Entries of a scene for one series; branches of zero modulus are left
    /// out.
    ParameterInclude material(const PronySeries &series) const;

    /// Entries with tables over @p f90, one series each, equal times; @p level
    /// is the entry f90 itself.
    ParameterInclude tables(const std::vector<double>      &f90,
                            const std::vector<PronySeries> &series,
                            double                          level) const;

  private:
    PronyResult fit_one(const std::vector<PronyCurve> &curves,
                        const std::vector<double>     &equilibrium,
                        const std::vector<double>     &start) const;

    unsigned int n_branches_max(const std::vector<PronyCurve> &curves) const;

    std::string         section;
    std::string         weights = "relative";
    std::string         kind    = "fixed";
    std::vector<double> times; // [s]
    unsigned int        branches      = 0;
    unsigned int        most_branches = 12;
    double              ratio         = 0.25; // mu2/mu1
    double              lambda        = 50.;  // [MPa]
  };
} // namespace demold

#endif
