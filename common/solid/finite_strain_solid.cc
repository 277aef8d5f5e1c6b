// SPDX-License-Identifier: LGPL-2.1-or-later
// The rubber of one body as a term of the weak form.
#include "solid/finite_strain_solid.h"

#include "base/plane_model.h"
#include "solid/cell_results.h"
#include "weak_form/assembler.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Stress and C of one cell, twice six numbers in one row.
    constexpr unsigned int n_means = 12;

    double largest_eigenvalue(const double *six)
    {
      SymmetricTensor<2, 3> tensor;
      std::copy(six, six + 6, tensor.begin_raw());
      return eigenvalues(tensor)[0];
    }

    template <int dim, int n_nodes>
    class FiniteStrainSolid
      : public Term
      , public CellResults
    {
    public:
      FiniteStrainSolid(const DoFHandler<dim, dim> &dof_handler,
                        const SolidDescription     &description)
        : description(description)
        , volume(description.element == "q1p0" ?
                   VolumeTreatment::mean_dilatation :
                   VolumeTreatment::pointwise)
        , quadrature(dof_handler.get_fe().degree + 1)
        , fe_values(dof_handler.get_fe(),
                    quadrature,
                    update_gradients | update_values | update_JxW_values |
                      update_quadrature_points)
        , points(quadrature.size())
        , indices(dim * n_nodes)
        , kernel_to_cell(dim * n_nodes)
        , residual(dim * n_nodes)
        , tangent(dim * n_nodes, dim * n_nodes)
      {
        const auto &fe = dof_handler.get_fe();
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            const auto component = fe.system_to_component_index(i);
            kernel_to_cell[component.second * dim + component.first] = i;
          }
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->material_id() == description.material_id)
            cells.push_back(cell);
        make_laws();
        trial_means.resize(n_means * cells.size(), 0.);
        for (std::size_t k = 0; k < cells.size(); ++k)
          std::fill_n(&trial_means[n_means * k + 6], 3, 1.); // C = 1
        committed_means = trial_means;
        for (const auto &cell : cells)
          f90.push_back(description.f90(in_space(cell->center())));
      }

      std::string name() const override
      {
        return "solid";
      }

      TermKind kind() const override
      {
        return TermKind::bulk;
      }

      bool symmetric() const override
      {
        return true;
      }

      bool assemble(const Configuration &now, Assembler &assembler) override
      {
        const bool with_tangent = assembler.with_tangent();
        const auto stride       = n_history * quadrature.size();
        double     u[dim * n_nodes];
        stored = dissipated = 0.;
        for (std::size_t k = 0; k < cells.size(); ++k)
          {
            reinit(cells[k]);
            for (int i = 0; i < dim * n_nodes; ++i)
              u[i] = now.u(indices[i]);
            if (!kernel.evaluate(points,
                                 u,
                                 laws.data() +
                                   (laws.size() > 1 ? k * points.size() : 0),
                                 laws.size() > 1 ? 1 : 0,
                                 volume,
                                 now.elapsed,
                                 committed.data() + k * stride,
                                 trial.data() + k * stride,
                                 with_tangent,
                                 result))
              return false;
            stored += result.stored;
            dissipated += result.dissipated;
            const auto mean = trial_means.begin() + n_means * k;
            std::copy(result.stress.begin(), result.stress.end(), mean);
            std::copy(result.C.begin(), result.C.end(), mean + 6);
            for (int i = 0; i < dim * n_nodes; ++i)
              residual(i) = result.residual[i];
            if (with_tangent)
              {
                for (int i = 0; i < dim * n_nodes; ++i)
                  for (int j = 0; j < dim * n_nodes; ++j)
                    tangent(i, j) = result.tangent[i][j];
                assembler.add(indices, residual, tangent);
              }
            else
              assembler.add(indices, residual);
          }
        return true;
      }

      Energies energies() const override
      {
        Energies e;
        e.stored  = stored;
        e.viscous = committed_viscous + dissipated;
        return e;
      }

      void commit() override
      {
        committed       = trial;
        committed_means = trial_means;
        committed_viscous += dissipated;
        committed_stored = stored;
        dissipated       = 0.;
      }

      void revert() override
      {
        trial      = committed;
        stored     = committed_stored;
        dissipated = 0.;
      }

      std::size_t history_bytes() const override
      {
        return (committed.size() + trial.size()) * sizeof(double);
      }

      void save(std::ostream &out) const override
      {
        write_values(out, committed);
        write_values(out, committed_means);
        write_values(out, {committed_viscous, committed_stored});
      }

      void load(std::istream &in) override
      {
        committed = trial = read_values(in);
        committed_means = trial_means = read_values(in);
        const auto sums               = read_values(in);
        committed_viscous             = sums.at(0);
        committed_stored = stored = sums.at(1);
        dissipated                = 0.;
      }

      std::vector<CellResult> cell_results() const override
      {
        std::vector<CellResult> results(cells.size());
        for (std::size_t k = 0; k < cells.size(); ++k)
          {
            const double *mean = &committed_means[n_means * k];
            CellResult   &cell = results[k];
            cell.index         = cells[k]->active_cell_index();
            std::copy(mean, mean + 6, cell.stress.begin());
            cell.largest_tension = largest_eigenvalue(mean);
            cell.largest_stretch = std::sqrt(largest_eigenvalue(mean + 6));
            cell.f90             = f90[k];
          }
        return results;
      }

    private:
      /// Fills `points` and `indices` (kernel order) for a cell.
      void
      reinit(const typename DoFHandler<dim, dim>::active_cell_iterator &cell)
      {
        fe_values.reinit(cell);
        cell_indices.resize(indices.size());
        cell->get_dof_indices(cell_indices);
        for (int i = 0; i < dim * n_nodes; ++i)
          indices[i] = cell_indices[kernel_to_cell[i]];
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const Point<dim> &X = fe_values.quadrature_point(q);
            points[q].weight =
              fe_values.JxW(q) * plane_weight<dim>(description.plane, X);
            for (int a = 0; a < n_nodes; ++a)
              {
                const unsigned int i = kernel_to_cell[a * dim];
                for (int j = 0; j < dim; ++j)
                  points[q].gradient[a][j] = fe_values.shape_grad(i, q)[j];
                points[q].hoop[a] = description.plane.axisymmetric && dim == 2 ?
                                      fe_values.shape_value(i, q) / X[0] :
                                      0.;
              }
          }
      }

      void make_laws()
      {
        if (description.uniform_law)
          laws.push_back(description.law(dealii::Point<3>()));
        else
          for (const auto &cell : cells)
            {
              fe_values.reinit(cell);
              for (unsigned int q = 0; q < points.size(); ++q)
                laws.push_back(
                  description.law(in_space(fe_values.quadrature_point(q))));
            }
        if (laws.empty())
          return;
        n_history = laws[0].n_history();
        committed.resize(cells.size() * points.size() * n_history);
        for (std::size_t p = 0;
             n_history > 0 && p < cells.size() * points.size();
             ++p)
          laws[laws.size() > 1 ? p : 0].initialize(committed.data() +
                                                   p * n_history);
        trial = committed;
      }

      const SolidDescription description;
      const VolumeTreatment  volume;
      const QGauss<dim>      quadrature;
      FEValues<dim>          fe_values;
      std::vector<typename DoFHandler<dim, dim>::active_cell_iterator> cells;

      std::vector<RubberLaw> laws; ///< one, or one per point
      unsigned int           n_history = 0;
      std::vector<double>    committed, trial;
      std::vector<double>    committed_means, trial_means; ///< n_means a cell
      std::vector<double>    f90;                          ///< one a cell
      double                 committed_viscous = 0., committed_stored = 0.;
      double                 stored = 0., dissipated = 0.;

      ElementKernel<dim, n_nodes>             kernel;
      ElementResult<dim, n_nodes>             result;
      std::vector<ElementPoint<dim, n_nodes>> points;
      std::vector<types::global_dof_index>    indices, cell_indices;
      std::vector<unsigned int>               kernel_to_cell;
      dealii::Vector<double>                  residual;
      FullMatrix<double>                      tangent;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Term> make_solid_term(const DoFHandler<dim, dim> &dof_handler,
                                        const SolidDescription     &description)
  {
    constexpr int linear = dim == 2 ? 4 : 8, quadratic = dim == 2 ? 9 : 27;
    if (dof_handler.get_fe().degree == 1)
      return std::make_unique<FiniteStrainSolid<dim, linear>>(dof_handler,
                                                              description);
    return std::make_unique<FiniteStrainSolid<dim, quadratic>>(dof_handler,
                                                               description);
  }

  template std::unique_ptr<Term> make_solid_term<2>(const DoFHandler<2, 2> &,
                                                    const SolidDescription &);
  template std::unique_ptr<Term> make_solid_term<3>(const DoFHandler<3, 3> &,
                                                    const SolidDescription &);
} // namespace demold
