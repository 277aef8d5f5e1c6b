// SPDX-License-Identifier: LGPL-2.1-or-later
// Mass, velocities and accelerations: the term that makes a run dynamic.
#include "solution/inertia.h"

#include "weak_form/assembler.h"
#include "weak_form/vector_io.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  void TimeIntegrator::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("integrator",
                      scheme,
                      "member of the Newmark family",
                      Patterns::Selection(
                        "bossak|generalised-alpha|newmark|hht"));
    prm.add_parameter("spectral radius",
                      spectral_radius,
                      "rho_inf of bossak and generalised-alpha at high "
                      "frequency [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("newmark damping",
                      newmark_damping,
                      "d in gamma = 1/2 + d, beta = (1/2 + gamma)^2/4 [-]",
                      Patterns::Double(0., .5));
    prm.add_parameter("hht alpha",
                      hht_alpha,
                      "alpha_H of Hilber, Hughes and Taylor [-]",
                      Patterns::Double(-1. / 3., 0.));
  }

  double TimeIntegrator::alpha_m() const
  {
    if (scheme == "bossak")
      return (spectral_radius - 1.) / (spectral_radius + 1.);
    return scheme == "generalised-alpha" ?
             (2. * spectral_radius - 1.) / (spectral_radius + 1.) :
             0.;
  }

  double TimeIntegrator::alpha_f() const
  {
    if (scheme == "generalised-alpha")
      return spectral_radius / (spectral_radius + 1.);
    return scheme == "hht" ? -hht_alpha : 0.;
  }

  double TimeIntegrator::gamma() const
  {
    if (scheme == "newmark")
      return .5 + newmark_damping;
    return .5 - alpha_m() + alpha_f();
  }

  double TimeIntegrator::beta() const
  {
    if (scheme == "newmark")
      return .25 * std::pow(.5 + gamma(), 2);
    return .25 * std::pow(1. - alpha_m() + alpha_f(), 2);
  }

  Inertia::Inertia(const Vector         &mass,
                   const TimeIntegrator &integrator,
                   const double          length)
    : mass(mass)
    , integrator(integrator)
    , length(length)
  {
    for (Vector *v : {&committed_velocity,
                      &committed_acceleration,
                      &velocity_trial,
                      &acceleration_trial})
      v->reinit(mass);
  }

  std::string Inertia::name() const
  {
    return "inertia";
  }

  TermKind Inertia::kind() const
  {
    return TermKind::inertia;
  }

  bool Inertia::symmetric() const
  {
    return true;
  }

  bool Inertia::assemble(const Configuration &now, Assembler &assembler)
  {
    dt = now.dt;
    if (at_rest)
      {
        follow(now);
        return true;
      }
    const double beta    = integrator.beta();
    const double gamma   = integrator.gamma();
    const double alpha_m = integrator.alpha_m();

    Assembler::Indices     index(1);
    dealii::Vector<double> r(1);
    FullMatrix<double>     K(1, 1);
    for (const auto i : mass.locally_owned_elements())
      {
        const double m = mass(i);
        if (m == 0.)
          continue;
        const double v = committed_velocity(i), a = committed_acceleration(i);
        const double a_new = (now.u(i) - now.u_old(i)) / (beta * dt * dt) -
                             v / (beta * dt) - (.5 / beta - 1.) * a;
        acceleration_trial(i) = a_new;
        velocity_trial(i)     = v + dt * ((1. - gamma) * a + gamma * a_new);

        index[0] = i;
        r(0)     = m * ((1. - alpha_m) * a_new + alpha_m * a);
        if (assembler.with_tangent())
          {
            K(0, 0) = m * (1. - alpha_m) / (beta * dt * dt);
            assembler.add(index, r, K);
          }
        else
          assembler.add(index, r);
      }
    velocity_trial.compress(VectorOperation::insert);
    acceleration_trial.compress(VectorOperation::insert);
    return true;
  }

  void Inertia::follow(const Configuration &now)
  {
    for (const auto i : mass.locally_owned_elements())
      velocity_trial(i) =
        mass(i) > 0. && dt > 0. ? (now.u(i) - now.u_old(i)) / dt : 0.;
    velocity_trial.compress(VectorOperation::insert);
    acceleration_trial = 0.;
  }

  void Inertia::set_at_rest(const bool rest)
  {
    if (rest == at_rest)
      return;
    at_rest             = rest;
    const double motion = kinetic_energy(committed_velocity);
    committed_algorithmic += rest ? motion : -motion;
    if (rest)
      committed_acceleration = 0.;
    revert();
  }

  void Inertia::forget_velocities()
  {
    committed_velocity = 0.;
    revert();
  }

  double Inertia::force_norm() const
  {
    double square = 0.;
    for (const auto i : mass.locally_owned_elements())
      square += std::pow(mass(i) * committed_acceleration(i), 2);
    return std::sqrt(Utilities::MPI::sum(square, mass.get_mpi_communicator()));
  }

  double Inertia::kinetic_energy() const
  {
    return Utilities::MPI::sum(kinetic_energy(committed_velocity),
                               mass.get_mpi_communicator());
  }

  double Inertia::kinetic_energy(const Vector &v) const
  {
    double twice = 0.;
    for (const auto i : mass.locally_owned_elements())
      twice += mass(i) * v(i) * v(i);
    return .5 * twice;
  }

  Energies Inertia::energies() const
  {
    Energies e;
    e.kinetic     = at_rest ? 0. : kinetic_energy(velocity_trial);
    e.algorithmic = committed_algorithmic + algorithmic;
    e.impact      = impact;
    return e;
  }

  void Inertia::account_damping(const WeakForm &weak_form)
  {
    Vector work(weak_form.force);
    work += weak_form.accepted_force;
    work *= -.5;
    weak_form.set_supports_to_zero(work);
    algorithmic =
      kinetic_energy(committed_velocity) - kinetic_energy(velocity_trial);
    for (const auto i : mass.locally_owned_elements())
      algorithmic += work(i) * (weak_form.trial(i) - weak_form.accepted(i));
  }

  IncrementError Inertia::increment_error() const
  {
    if (at_rest)
      return {};
    double largest = 0.;
    for (const auto i : mass.locally_owned_elements())
      largest =
        std::max(largest,
                 std::abs(acceleration_trial(i) - committed_acceleration(i)));
    largest = Utilities::MPI::max(largest, mass.get_mpi_communicator());
    return {dt * dt * std::abs(integrator.beta() - 1. / 6.) * largest /
              (2. * length),
            3.};
  }

  void Inertia::close(const std::vector<ClosedPoint> &points)
  {
    const double before = kinetic_energy(committed_velocity);
    for (const ClosedPoint &point : points)
      {
        double v_n = 0., a_n = 0.;
        for (unsigned int d = 0; d < point.unknowns.size(); ++d)
          {
            v_n += (committed_velocity(point.unknowns[d]) - point.velocity[d]) *
                   point.normal[d];
            a_n += committed_acceleration(point.unknowns[d]) * point.normal[d];
          }
        for (unsigned int d = 0; d < point.unknowns.size(); ++d)
          {
            const auto i = point.unknowns[d];
            committed_velocity(i) =
              committed_velocity(i) - v_n * point.normal[d];
            committed_acceleration(i) =
              committed_acceleration(i) - a_n * point.normal[d];
          }
      }
    committed_velocity.compress(VectorOperation::insert);
    committed_acceleration.compress(VectorOperation::insert);
    velocity_trial     = committed_velocity;
    acceleration_trial = committed_acceleration;
    impact += before - kinetic_energy(committed_velocity);
  }

  void Inertia::commit()
  {
    committed_velocity     = velocity_trial;
    committed_acceleration = acceleration_trial;
    committed_algorithmic += algorithmic;
    algorithmic = 0.;
  }

  void Inertia::revert()
  {
    velocity_trial     = committed_velocity;
    acceleration_trial = committed_acceleration;
    algorithmic        = 0.;
  }

  std::size_t Inertia::history_bytes() const
  {
    return 4 * sizeof(double) * mass.locally_owned_size();
  }

  void Inertia::save(std::ostream &out) const
  {
    write_owned(out, committed_velocity);
    write_owned(out, committed_acceleration);
    write_values(out, {committed_algorithmic, impact, at_rest ? 1. : 0.});
  }

  void Inertia::load(std::istream &in)
  {
    read_owned(in, committed_velocity);
    read_owned(in, committed_acceleration);
    const auto sums       = read_values(in);
    committed_algorithmic = sums.at(0);
    impact                = sums.at(1);
    at_rest               = sums.at(2) > 0.;
    revert();
  }
} // namespace demold
