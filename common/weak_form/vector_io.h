// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact binary copies of vectors and histories for checkpoints.
#ifndef demold_weak_form_vector_io_h
#define demold_weak_form_vector_io_h

#include "weak_form/algebra.h"

#include <iosfwd>
#include <vector>

namespace demold
{
  /// Writes a length and the values, bitwise.
  void write_values(std::ostream &out, const std::vector<double> &values);

  /// Reads what write_values() wrote; throws std::runtime_error at the end of
  /// a damaged file.
  std::vector<double> read_values(std::istream &in);

  /// The entries of this rank, in the order of their indices.
  void write_owned(std::ostream &out, const Vector &vector);

  /// Reads them back into a vector of the same layout.
  void read_owned(std::istream &in, Vector &vector);
} // namespace demold

#endif
