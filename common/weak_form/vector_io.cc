// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact binary copies of vectors and histories for checkpoints.
#include "weak_form/vector_io.h"

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>

namespace demold
{
  void write_values(std::ostream &out, const std::vector<double> &values)
  {
    const std::uint64_t n = values.size();
    out.write(reinterpret_cast<const char *>(&n), sizeof(n));
    out.write(reinterpret_cast<const char *>(values.data()),
              n * sizeof(double));
  }

  std::vector<double> read_values(std::istream &in)
  {
    std::uint64_t n = 0;
    in.read(reinterpret_cast<char *>(&n), sizeof(n));
    if (!in || n > (std::uint64_t(1) << 40))
      throw std::runtime_error("the checkpoint is damaged or ends too early");
    std::vector<double> values(n);
    in.read(reinterpret_cast<char *>(values.data()), n * sizeof(double));
    if (!in)
      throw std::runtime_error("the checkpoint is damaged or ends too early");
    return values;
  }

  void write_owned(std::ostream &out, const Vector &vector)
  {
    std::vector<double> values;
    for (const auto i : vector.locally_owned_elements())
      values.push_back(vector(i));
    write_values(out, values);
  }

  void read_owned(std::istream &in, Vector &vector)
  {
    const auto owned  = vector.locally_owned_elements();
    const auto values = read_values(in);
    if (values.size() != owned.n_elements())
      throw std::runtime_error(
        "the checkpoint was written for " + std::to_string(values.size()) +
        " unknowns on this rank, the scene has " +
        std::to_string(owned.n_elements()) +
        "; restart with the same scene and number of ranks");
    std::size_t k = 0;
    for (const auto i : owned)
      vector(i) = values[k++];
    vector.compress(dealii::VectorOperation::insert);
  }
} // namespace demold
