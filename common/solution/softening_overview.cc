// SPDX-License-Identifier: LGPL-2.1-or-later
// All points of a weak form that may soften, over terms and ranks.
#include "solution/softening_overview.h"

#include "weak_form/weak_form.h"

#include <deal.II/base/mpi.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    MPI_Comm communicator(const WeakForm &weak_form)
    {
      return weak_form.trial.get_mpi_communicator();
    }
  } // namespace

  bool is_critical(const SofteningSite &site)
  {
    return site.utilisation >= critical_utilisation && site.left > 0.;
  }

  std::vector<SofteningSite> softening_sites(const WeakForm &weak_form)
  {
    std::vector<SofteningSite> all;
    for (const auto &term : weak_form.term_list())
      if (const auto *softening = dynamic_cast<SofteningTerm *>(term.get()))
        for (SofteningSite &point : softening->softening_sites())
          all.push_back(std::move(point));
    return all;
  }

  unsigned int drive(WeakForm &weak_form,
                     const std::function<bool(const SofteningSite &)> &chosen)
  {
    unsigned int n = 0;
    for (const auto &term : weak_form.term_list())
      if (auto *softening = dynamic_cast<SofteningTerm *>(term.get()))
        {
          std::vector<bool> driven;
          for (const SofteningSite &point : softening->softening_sites())
            {
              driven.push_back(chosen(point));
              n += driven.back() ? 1 : 0;
            }
          softening->drive(driven);
        }
    return Utilities::MPI::sum(n, communicator(weak_form));
  }

  void add_gap_gradient(const SofteningSite &point,
                        const Tensor<1, 3>  &along,
                        const double         factor,
                        Vector              &h)
  {
    std::vector<double> values;
    for (std::size_t k = 0; k < point.unknowns.size(); ++k)
      values.push_back(factor * along[point.components[k]] * point.weights[k]);
    h.add(point.unknowns, values);
  }

  double sum_over_ranks(const WeakForm &weak_form, const double of_this_rank)
  {
    return Utilities::MPI::sum(of_this_rank, communicator(weak_form));
  }

  double max_over_ranks(const WeakForm &weak_form, const double of_this_rank)
  {
    return Utilities::MPI::max(of_this_rank, communicator(weak_form));
  }
} // namespace demold
