// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of cure that a press cycle gives the block of a scene.
#include "scene/vulcanised_cure.h"

#include "base/parameter_error.h"
#include "output/plots.h"
#include "scene/scene_parameters.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::map<types::boundary_id, typename HeatConduction<dim>::Side>
    heated_sides(const Scene<dim> &scene)
    {
      if (scene.mould_side.empty() && scene.bladder_side.empty())
        throw ExcParameter("Material/cure",
                           "must be uniform or function for a body that no "
                           "press has made; got vulcanised. A tread block "
                           "(step-demold) has a mould and a bladder side.");
      using Side = typename HeatConduction<dim>::Side;
      std::map<types::boundary_id, Side> sides;
      for (const types::boundary_id id : scene.mould_side)
        sides[id] = Side::mould;
      for (const types::boundary_id id : scene.bladder_side)
        sides[id] = Side::bladder;
      return sides;
    }



    /// Colours over the slice; @p column of vulcanisation.dat.
    std::string map_script(const std::string &name,
                           const std::string &title,
                           const std::string &unit,
                           const int          column)
    {
      return plot_head(name, title) + "set size ratio -1\n" +
             "set xlabel 'x [mm]'\n"
             "set ylabel 'y [mm]'\n"
             "set cblabel '" +
             unit +
             "'\n"
             "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', "
             "3 '#5ec962', 4 '#fde725')\n"
             "set pm3d map interpolate 2,2\n"
             "set nokey\n"
             "splot 'vulcanisation.dat' using 1:2:" +
             std::to_string(column) + " with pm3d\n";
    }



    template <typename Write>
    void write_file(const std::string &file, const Write &write)
    {
      std::ofstream out(file);
      write(out);
      out.close();
      if (!out)
        throw std::runtime_error("cannot write " + file +
                                 ": is the disk full?");
    }
  } // namespace



  template <int dim>
  VulcanisedCure<dim>::VulcanisedCure(const Scene<dim>      &scene,
                                      const SceneParameters &parameters)
    : bounds(parameters.material.f90_range())
  {
    const auto sides = heated_sides(scene);
    scene.make_mesh(triangulation);
    heat = std::make_unique<HeatConduction<dim>>(triangulation,
                                                 parameters.press.cycle(),
                                                 sides);
    heat->run(parameters.cure.model().t90);
    extremes = find_range(scene, parameters.element == "q2" ? 3 : 2);
  }



  template <int dim>
  double VulcanisedCure<dim>::f90(const dealii::Point<3> &X) const
  {
    Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = X[d];
    return std::clamp(heat->value_at(heat->at_opening.f90, point),
                      bounds.first,
                      bounds.second);
  }



  template <int dim>
  VulcanisedRange
  VulcanisedCure<dim>::find_range(const Scene<dim>  &scene,
                                  const unsigned int n_points) const
  {
    const FiniteElement<dim> &element = heat->nodes().get_fe();
    FEValues<dim>             fe_values(element,
                            QGauss<dim>(n_points),
                            update_values | update_JxW_values);
    const unsigned int        n = fe_values.n_quadrature_points;
    std::vector<double>       f90(n), temperature(n);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    VulcanisedRange  range =
      {infinity, 0., -infinity, infinity, -infinity, 0, 0};
    double volume = 0.;
    for (const auto &cell : heat->nodes().active_cell_iterators())
      {
        if (scene.laws.count(cell->material_id()) > 0)
          continue;
        fe_values.reinit(cell);
        fe_values.get_function_values(heat->at_opening.f90, f90);
        fe_values.get_function_values(heat->at_opening.temperature,
                                      temperature);
        for (unsigned int q = 0; q < n; ++q)
          {
            range.smallest = std::min(range.smallest, f90[q]);
            range.largest  = std::max(range.largest, f90[q]);
            range.coldest  = std::min(range.coldest, temperature[q]);
            range.hottest  = std::max(range.hottest, temperature[q]);
            range.mean += f90[q] * fe_values.JxW(q);
            volume += fe_values.JxW(q);
            if (f90[q] < bounds.first || f90[q] > bounds.second)
              ++range.n_clamped;
          }
        range.n_points += n;
      }
    range.mean /= volume;
    return range;
  }



  template <int dim>
  std::string VulcanisedCure<dim>::warning() const
  {
    std::ostringstream text;
    if (extremes.n_clamped > 0)
      text << "WARNING: f90 lies outside Material/table f90, " << bounds.first
           << " to " << bounds.second << ", at " << extremes.n_clamped << " of "
           << extremes.n_points << " points; the press cycle gives "
           << extremes.smallest << " to " << extremes.largest
           << ". The nearest level is used there. Change Press/opening time or "
              "extend the tables.";
    return text.str();
  }



  template <int dim>
  std::string VulcanisedCure<dim>::write(const std::string &output_folder) const
  {
    DataOut<dim> data;
    data.attach_dof_handler(heat->nodes());
    data.add_data_vector(heat->at_opening.temperature,
                         "temperature_at_opening");
    data.add_data_vector(heat->at_opening.f90, "f90_at_opening");
    data.add_data_vector(heat->at_end.f90, "f90_at_end");
    data.build_patches();
    const std::string name = output_folder + "/vulcanisation";
    write_file(name + ".vtu", [&](std::ostream &out) { data.write_vtu(out); });
    if (dim == 3)
      return "";
    write_file(name + ".dat",
               [&](std::ostream &out) { data.write_gnuplot(out); });
    return draw_scripts(output_folder,
                        {{"temperature-at-opening.gp",
                          map_script("temperature-at-opening",
                                     "Temperature when the press opens",
                                     "temperature [degC]",
                                     3)},
                         {"f90-at-opening.gp",
                          map_script("f90-at-opening",
                                     "State of cure when the press opens",
                                     "f90 [-]",
                                     4)}});
  }



  template class VulcanisedCure<2>;
  template class VulcanisedCure<3>;
} // namespace demold
