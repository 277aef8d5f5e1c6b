// SPDX-License-Identifier: LGPL-2.1-or-later
// Two warped surfaces, not matching, and the interface term between them.
#ifndef demold_tests_contact_term_two_surfaces_h
#define demold_tests_contact_term_two_surfaces_h

#include "contact/node_to_segment.h"
#include "mortar/mortar_term.h"
#include "weak_form/assembler.h"

#include <cmath>
#include <memory>
#include <random>
#include <sstream>

namespace demold
{
  /// Keeps residual and tangent as plain arrays.
  class DenseAssembler : public Assembler
  {
  public:
    explicit DenseAssembler(const unsigned int n)
      : R(n)
      , K(n, n)
    {}

    bool with_tangent() const override
    {
      return true;
    }

    void add(const Indices &indices, const dealii::Vector<double> &r) override
    {
      for (unsigned int i = 0; i < indices.size(); ++i)
        R(indices[i]) += r(i);
    }

    void add(const Indices                    &indices,
             const dealii::Vector<double>     &r,
             const dealii::FullMatrix<double> &k) override
    {
      add(indices, r);
      for (unsigned int i = 0; i < indices.size(); ++i)
        for (unsigned int j = 0; j < indices.size(); ++j)
          K(indices[i], indices[j]) += k(i, j);
    }

    dealii::Vector<double>     R;
    dealii::FullMatrix<double> K;
  };

  /// Height of a surface over (x, y) [mm].
  using HeightOf = std::function<double(double, double)>;

  /// Grid of n x n facets (2-D: n lines) over [from, to] in each direction.
  struct Grid
  {
    unsigned int dim;
    unsigned int n;
    double       from, to;
    HeightOf     z; ///< in 2-D the y coordinate
    bool         faces_up;
  };

  inline BoundarySurface
  make_surface(const Grid                           &grid,
               const dealii::types::global_dof_index first_unknown)
  {
    BoundarySurface    surface;
    const unsigned int n_y  = grid.dim == 2 ? 0 : grid.n;
    auto               next = first_unknown;
    for (unsigned int j = 0; j <= n_y; ++j)
      for (unsigned int i = 0; i <= grid.n; ++i)
        {
          const double          h = (grid.to - grid.from) / grid.n;
          const double          x = grid.from + i * h;
          const double          y = grid.dim == 2 ? 0. : grid.from + j * h;
          BoundarySurface::Node node;
          node.X = grid.dim == 2 ? dealii::Point<3>(x, grid.z(x, y), 0.) :
                                   dealii::Point<3>(x, y, grid.z(x, y));
          node.unknowns.fill(next);
          for (unsigned int d = 0; d < grid.dim; ++d)
            node.unknowns[d] = next++;
          surface.nodes.push_back(node);
        }
    const unsigned int row = grid.n + 1;
    for (unsigned int j = 0; j < (grid.dim == 2 ? 1 : grid.n); ++j)
      for (unsigned int i = 0; i < grid.n; ++i)
        {
          const unsigned int a = i + row * j;
          Facet              facet;
          if (grid.dim == 2) // the body lies to the left
            facet = {{{a + 1, a, 0, 0}}, 2};
          else
            facet = {{{a, a + 1, a + 1 + row, a + row}}, 4};
          if (!grid.faces_up)
            std::swap(facet.nodes[grid.dim == 2 ? 0 : 1],
                      facet.nodes[grid.dim == 2 ? 1 : 3]);
          surface.facets.push_back(facet);
          surface.height.push_back(4.);
        }
    return surface;
  }

  /// Which master the surfaces get.
  enum class MasterKind
  {
    rigid,
    deformable
  };

  enum class Formulation
  {
    node_to_segment,
    mortar
  };

  /// The term alone, with its unknowns as plain arrays: displacements of the
  /// slave nodes, of the master nodes, then multipliers.
  class TwoSurfaces
  {
  public:
    using Values = std::vector<double>;

    TwoSurfaces(
      const Grid                 &slave_grid,
      const Grid                 &master_grid,
      const MasterKind            kind,
      const InterfaceDescription &description,
      const RigidMotion &motion      = [](double) { return RigidPlacement(); },
      const Formulation  formulation = Formulation::node_to_segment)
      : dim(slave_grid.dim)
      , slave(make_surface(slave_grid, 0))
      , master(make_surface(master_grid, dim * slave.nodes.size()))
      , kind(kind)
    {
      // A rigid master takes no unknowns, but they do no harm either.
      n_displacements = dim * (slave.nodes.size() + master.nodes.size());
      make_term(description, motion, formulation);
      n = n_displacements + term->extra_unknown_owners().size();
      term->set_first_extra_unknown(n_displacements);
      accepted = Values(n, 0.);
      for (Vector *v : {&u, &u_old})
        v->reinit(dealii::complete_index_set(n), MPI_COMM_SELF);
    }

    /// Residual and tangent at the trial @p values.
    DenseAssembler evaluate(const Values      &values,
                            const unsigned int iteration = 0)
    {
      DenseAssembler result(n);
      evaluate(values, result, iteration);
      return result;
    }

    /// @p between is done when the term has seen the state and knows its
    /// couplings.
    void evaluate(
      const Values                &values,
      Assembler                   &assembler,
      const unsigned int           iteration = 0,
      const std::function<void()> &between   = [] {})
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          u(i)     = values[i];
          u_old(i) = accepted[i];
        }
      u.compress(dealii::VectorOperation::insert);
      u_old.compress(dealii::VectorOperation::insert);
      const Configuration now = {u, u_old, time + dt, dt, iteration};
      term->prepare(now);
      between();
      term->assemble(now, assembler);
    }

    /// Goes to @p values and accepts them.
    void accept(const Values &values)
    {
      evaluate(values);
      term->commit();
      accepted = values;
      time += dt;
    }

    /// The same displacement of all slave nodes.
    Values shifted_slave(const dealii::Tensor<1, 3> &shift) const
    {
      Values values(n, 0.);
      for (const auto &node : slave.nodes)
        for (unsigned int d = 0; d < dim; ++d)
          values[node.unknowns[d]] = shift[d];
      return values;
    }

    /// @p values plus noise of @p amplitude [mm] on every node that moves.
    Values with_noise(Values       values,
                      const double amplitude,
                      const int    seed) const
    {
      std::mt19937                           generator(seed);
      std::uniform_real_distribution<double> noise(-amplitude, amplitude);
      for (unsigned int i = 0; i < n; ++i)
        if (is_moving(i))
          values[i] += noise(generator);
      return values;
    }

    /// Does the unknown change anything?
    bool is_moving(const unsigned int i) const
    {
      return kind == MasterKind::deformable || i < dim * slave.nodes.size() ||
             i >= n_displacements;
    }

    /// Largest entry of the tangent that differs from central differences of
    /// the residual, over the largest entry.
    double tangent_error(const Values &at, const unsigned int iteration = 0)
    {
      const DenseAssembler exact   = evaluate(at, iteration);
      const double         step    = 1e-6;
      double               largest = 0., error = 0.;
      for (unsigned int j = 0; j < n; ++j)
        {
          if (!is_moving(j))
            continue;
          Values plus = at, minus = at;
          plus[j] += step;
          minus[j] -= step;
          const auto R_plus  = evaluate(plus, iteration).R;
          const auto R_minus = evaluate(minus, iteration).R;
          for (unsigned int i = 0; i < n; ++i)
            {
              if (!is_moving(i))
                continue;
              const double difference = (R_plus(i) - R_minus(i)) / (2. * step);
              largest                 = std::max(largest, std::abs(difference));
              error = std::max(error, std::abs(difference - exact.K(i, j)));
            }
        }
      evaluate(at, iteration);
      return largest > 0. ? error / largest : 1e300;
    }

    /// State (theory C.5) of each slave point.
    std::vector<int> states() const
    {
      std::vector<int> list;
      for (const PointReport &point : term->report())
        list.push_back(point.state);
      return list;
    }

    unsigned int count(const int state) const
    {
      const auto list = states();
      return std::count(list.begin(), list.end(), state);
    }

    std::string saved() const
    {
      std::ostringstream out;
      term->save(out);
      return out.str();
    }

    const unsigned int             dim;
    const BoundarySurface          slave, master;
    const MasterKind               kind;
    unsigned int                   n = 0, n_displacements = 0;
    double                         time = 0., dt = 1.;
    Values                         accepted;
    Vector                         u, u_old;
    std::unique_ptr<InterfaceTerm> term;

  private:
    void make_term(const InterfaceDescription &description,
                   const RigidMotion          &motion,
                   const Formulation           formulation)
    {
      const Master other =
        kind == MasterKind::rigid ?
          Master::rigid(master.facets, master.positions(), motion) :
          Master::deformable(master);
      const auto owned = dealii::complete_index_set(n_displacements);
      if (formulation == Formulation::mortar)
        term = std::make_unique<MortarTerm>(
          slave,
          other,
          description,
          owned,
          [](dealii::types::global_dof_index) { return false; },
          MPI_COMM_SELF);
      else
        term = std::make_unique<NodeToSegment>(slave,
                                               other,
                                               description,
                                               owned,
                                               MPI_COMM_SELF);
    }
  };
} // namespace demold

#endif
