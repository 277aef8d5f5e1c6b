// SPDX-License-Identifier: LGPL-2.1-or-later
// A load per reference area that keeps its direction.
#include "solid/dead_traction.h"

#include "weak_form/assembler.h"
#include "weak_form/dead_load.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    class DeadTraction
      : public Term
      , public DeadLoad
    {
    public:
      std::string name() const override
      {
        return "traction";
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
        const Tensor<1, 3>     T     = traction(now.time);
        const Tensor<1, 3>     T_old = traction(now.time - now.dt);
        dealii::Vector<double> r(1);
        work  = 0.;
        moved = Tensor<1, 3>();
        for (std::size_t k = 0; k < unknowns.size(); ++k)
          {
            moved[components[k]] += areas[k] * now.u(unknowns[k]);
            const Assembler::Indices index = {unknowns[k]};
            r(0)                           = -areas[k] * T[components[k]];
            assembler.add(index, r);
            work += .5 * areas[k] * (T[components[k]] + T_old[components[k]]) *
                    (now.u(unknowns[k]) - now.u_old(unknowns[k]));
          }
        return true;
      }

      Energies energies() const override
      {
        Energies e;
        e.external = committed_work + work;
        return e;
      }

      void commit() override
      {
        committed_work += work;
        work = 0.;
      }

      void revert() override
      {
        work = 0.;
      }

      std::size_t history_bytes() const override
      {
        return 0;
      }

      void save(std::ostream &out) const override
      {
        write_values(out, {committed_work});
      }

      void load(std::istream &in) override
      {
        committed_work = read_values(in).at(0);
        work           = 0.;
      }

      double potential(const double time) const override
      {
        return traction(time) * moved;
      }

      std::function<Tensor<1, 3>(double)>  traction;
      std::vector<types::global_dof_index> unknowns;
      std::vector<unsigned int>            components;
      std::vector<double>                  areas; ///< integral of N [mm^2]

    private:
      double       work = 0., committed_work = 0.; ///< [mJ]
      Tensor<1, 3> moved; ///< integral of u at the last assembly [mm^3]
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Term>
  make_dead_traction(const DoFHandler<dim, dim>                &dof_handler,
                     const types::boundary_id                   boundary_id,
                     const std::function<Tensor<1, 3>(double)> &traction,
                     const PlaneModel                          &plane)
  {
    auto term      = std::make_unique<DeadTraction>();
    term->traction = traction;

    const auto                          &fe = dof_handler.get_fe();
    const QGauss<dim - 1>                quadrature(fe.degree + 1);
    FEFaceValues<dim>                    values(fe,
                             quadrature,
                             update_values | update_JxW_values |
                               update_quadrature_points);
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->is_locally_owned() && cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == boundary_id)
          {
            values.reinit(cell, f);
            cell->get_dof_indices(indices);
            for (unsigned int i = 0; i < indices.size(); ++i)
              if (fe.has_support_on_face(i, f))
                {
                  double area = 0.;
                  for (unsigned int q = 0; q < quadrature.size(); ++q)
                    area +=
                      values.shape_value(i, q) * values.JxW(q) *
                      plane_weight<dim>(plane, values.quadrature_point(q));
                  term->unknowns.push_back(indices[i]);
                  term->components.push_back(
                    fe.system_to_component_index(i).first);
                  term->areas.push_back(area);
                }
          }
    return term;
  }

  template std::unique_ptr<Term>
  make_dead_traction<2>(const DoFHandler<2, 2> &,
                        const types::boundary_id,
                        const std::function<Tensor<1, 3>(double)> &,
                        const PlaneModel &);
  template std::unique_ptr<Term>
  make_dead_traction<3>(const DoFHandler<3, 3> &,
                        const types::boundary_id,
                        const std::function<Tensor<1, 3>(double)> &,
                        const PlaneModel &);
} // namespace demold
