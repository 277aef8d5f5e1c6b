// SPDX-License-Identifier: LGPL-2.1-or-later
// Velocities and accelerations of explicit dynamics, and their energies.
#include "solution/central_differences.h"

#include "weak_form/vector_io.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/mpi.h>

namespace demold
{
  using namespace dealii;

  CentralDifferences::CentralDifferences(const Vector &mass)
    : mass(mass)
  {
    for (Vector *v : {&committed_velocity,
                      &committed_acceleration,
                      &velocity_trial,
                      &acceleration_trial})
      v->reinit(mass);
  }

  std::string CentralDifferences::name() const
  {
    return "central differences";
  }

  TermKind CentralDifferences::kind() const
  {
    return TermKind::inertia;
  }

  bool CentralDifferences::symmetric() const
  {
    return true;
  }

  bool CentralDifferences::assemble(const Configuration &, Assembler &)
  {
    return true;
  }

  void CentralDifferences::find_free_masses(const WeakForm &weak_form)
  {
    if (free_mass.size() > 0)
      return;
    free_mass = mass;
    weak_form.set_supports_to_zero(free_mass);
  }

  void CentralDifferences::start(const WeakForm &weak_form)
  {
    find_free_masses(weak_form);
    for (const auto i : mass.locally_owned_elements())
      committed_acceleration(i) =
        free_mass(i) > 0. ? -weak_form.force(i) / free_mass(i) : 0.;
    committed_acceleration.compress(VectorOperation::insert);
  }

  Vector CentralDifferences::increment(const double dt) const
  {
    Vector du(committed_velocity);
    du.sadd(dt, .5 * dt * dt, committed_acceleration);
    return du;
  }

  void CentralDifferences::kick(const WeakForm &weak_form, const double dt)
  {
    find_free_masses(weak_form);
    algorithmic = 0.;
    for (const auto i : mass.locally_owned_elements())
      {
        const double m = free_mass(i), a = committed_acceleration(i);
        if (m == 0.) // where the support leads it
          {
            const double moved = weak_form.trial(i) - weak_form.accepted(i);
            const double v = committed_velocity(i), v_new = moved / dt;
            acceleration_trial(i) = 0.;
            velocity_trial(i)     = v_new;
            algorithmic -= .5 * mass(i) * (v_new * v_new - v * v);
            continue;
          }
        const double a_new    = -weak_form.force(i) / m;
        acceleration_trial(i) = a_new;
        velocity_trial(i)     = committed_velocity(i) + .5 * dt * (a + a_new);
        algorithmic += m * dt * dt / 8. * (a * a - a_new * a_new);
      }
    acceleration_trial.compress(VectorOperation::insert);
    velocity_trial.compress(VectorOperation::insert);
  }

  void CentralDifferences::close(const std::vector<ClosedPoint> &points)
  {
    const double before = kinetic_energy(mass, committed_velocity);
    for (const ClosedPoint &point : points)
      {
        double v_n = 0.;
        for (unsigned int d = 0; d < point.unknowns.size(); ++d)
          v_n += (committed_velocity(point.unknowns[d]) - point.velocity[d]) *
                 point.normal[d];
        for (unsigned int d = 0; d < point.unknowns.size(); ++d)
          {
            const auto i = point.unknowns[d];
            committed_velocity(i) =
              committed_velocity(i) - v_n * point.normal[d];
          }
      }
    committed_velocity.compress(VectorOperation::insert);
    velocity_trial = committed_velocity;
    impact += before - kinetic_energy(mass, committed_velocity);
  }

  double CentralDifferences::free_kinetic_energy() const
  {
    return Utilities::MPI::sum(kinetic_energy(free_mass, velocity_trial),
                               mass.get_mpi_communicator());
  }

  double CentralDifferences::kinetic_energy(const Vector &masses,
                                            const Vector &v) const
  {
    double twice = 0.;
    for (const auto i : masses.locally_owned_elements())
      twice += masses(i) * v(i) * v(i);
    return .5 * twice;
  }

  Energies CentralDifferences::energies() const
  {
    Energies e;
    e.kinetic     = kinetic_energy(mass, velocity_trial);
    e.algorithmic = committed_algorithmic + algorithmic;
    e.impact      = impact;
    return e;
  }

  void CentralDifferences::commit()
  {
    committed_velocity     = velocity_trial;
    committed_acceleration = acceleration_trial;
    committed_algorithmic += algorithmic;
    algorithmic = 0.;
  }

  void CentralDifferences::revert()
  {
    velocity_trial     = committed_velocity;
    acceleration_trial = committed_acceleration;
    algorithmic        = 0.;
  }

  std::size_t CentralDifferences::history_bytes() const
  {
    return 4 * sizeof(double) * mass.locally_owned_size();
  }

  void CentralDifferences::save(std::ostream &out) const
  {
    write_owned(out, committed_velocity);
    write_owned(out, committed_acceleration);
    write_values(out, {committed_algorithmic, impact});
  }

  void CentralDifferences::load(std::istream &in)
  {
    read_owned(in, committed_velocity);
    read_owned(in, committed_acceleration);
    const auto sums       = read_values(in);
    committed_algorithmic = sums.at(0);
    impact                = sums.at(1);
    revert();
  }
} // namespace demold
