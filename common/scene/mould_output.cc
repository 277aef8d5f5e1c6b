// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of the rigid mould where it is.
#include "scene/mould_output.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <deal.II/grid/reference_cell.h>

#include <fstream>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// deal.II numbers the corners of a cell line by line, a facet goes round.
    constexpr unsigned int corner_of_cell[4] = {0, 1, 3, 2};

    template <int dim>
    std::vector<DataOutBase::Patch<dim - 1, 3>>
    patches_of(const RigidSurface &surface, const RigidPlacement &placement)
    {
      constexpr unsigned int n = GeometryInfo<dim - 1>::vertices_per_cell;
      std::vector<DataOutBase::Patch<dim - 1, 3>> patches;
      for (std::size_t f = 0; f < surface.facets.size(); ++f)
        {
          DataOutBase::Patch<dim - 1, 3> patch;
          patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
          for (unsigned int k = 0; k < n; ++k)
            patch.vertices[k] = placement.place(
              surface.vertices[surface.facets[f].v[corner_of_cell[k]]]);
          patch.patch_index = f;
          patch.data.reinit(1, n);
          for (unsigned int k = 0; k < n; ++k)
            patch.data(0, k) = surface.patch[f];
          patches.push_back(patch);
        }
      return patches;
    }
  } // namespace

  template <int dim>
  MouldOutput<dim>::MouldOutput(const RigidSurface &surface,
                                const RigidMotion  &motion,
                                const std::string  &output_folder)
    : series(output_folder, "mould", "mould-")
    , surface(surface)
    , motion(motion)
  {}

  template <int dim>
  void MouldOutput<dim>::write(const double time)
  {
    const std::string file = series.next_file();
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream out(file);
        DataOutBase::write_vtu(patches_of<dim>(surface, motion(time)),
                               {"patch"},
                               {},
                               DataOutBase::VtkFlags(time),
                               out);
        out.close();
        if (!out)
          throw std::runtime_error("could not write " + file +
                                   "; is the disk full?");
      }
    series.add(time);
  }

  template class MouldOutput<2>;
  template class MouldOutput<3>;
} // namespace demold
