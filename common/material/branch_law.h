// SPDX-License-Identifier: LGPL-2.1-or-later
// The names of the flow rules that the Maxwell branches may follow.
#ifndef demold_material_branch_law_h
#define demold_material_branch_law_h

#include <string>

namespace demold
{
  /// What a Maxwell branch is at finite strain (theory A.2). All have the same
  /// moduli and relaxation times and agree at small isochoric strain.
  enum class BranchLaw
  {
    isochoric,  ///< V1: Reese-Govindjee flow of an isochoric neo-Hooke spring
    linear,     ///< V2: dC_i/dt = (C - C_i)/tau
    lubliner,   ///< V3: d(C_i^-1)/dt = (C^-1 - C_i^-1)/tau
    convolution ///< V4: the history of the isochoric elastic stress, fading
  };

  /// All names, separated by '|', as the pattern of an entry wants them.
  constexpr const char *branch_law_names =
    "isochoric neo-hooke|linear evolution|lubliner|stress convolution";

  /// The law of one of these names.
  inline BranchLaw branch_law_by_name(const std::string &name)
  {
    return name == "linear evolution"   ? BranchLaw::linear :
           name == "lubliner"           ? BranchLaw::lubliner :
           name == "stress convolution" ? BranchLaw::convolution :
                                          BranchLaw::isochoric;
  }
} // namespace demold

#endif
