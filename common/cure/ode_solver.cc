// SPDX-License-Identifier: LGPL-2.1-or-later
// Ordinary differential equations with controlled error, by SUNDIALS ARKODE.
#include "cure/ode_solver.h"

#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spbcgs.h>

#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace demold
{
  namespace
  {
    constexpr long n_steps_max       = 1000000;
    constexpr int  n_krylov_steps    = 300;
    constexpr int  order_explicit    = 5;
    constexpr int  order_implicit    = 4;
    constexpr int  unrecoverable     = -1;
    constexpr int  not_a_number_code = 1; // ARKODE tries a shorter step

    const double *values(const N_Vector v)
    {
      return N_VGetArrayPointer(v);
    }

    double *values_of(N_Vector v)
    {
      return N_VGetArrayPointer(v);
    }
  } // namespace



  /// Owns what the C interface hands out. Not copied: ARKODE keeps its address.
  struct OdeSolver::Arkode
  {
    OdeProblem          problem;
    double              time;
    std::vector<double> state;
    std::exception_ptr  thrown;
    std::string         complaint;
    SUNContext          context = nullptr;
    N_Vector            y       = nullptr;
    void               *memory  = nullptr;
    SUNLinearSolver     solver  = nullptr;

    Arkode(const OdeProblem          &problem,
           const double               start,
           const std::vector<double> &initial)
      : problem(problem)
      , time(start)
      , state(initial)
    {}
    Arkode(const Arkode &) = delete;

    ~Arkode()
    {
      if (memory != nullptr)
        ARKStepFree(&memory);
      if (solver != nullptr)
        SUNLinSolFree(solver);
      if (y != nullptr)
        N_VDestroy(y);
      if (context != nullptr)
        SUNContext_Free(&context);
    }

    /// Runs @p function for a C callback, which must not throw.
    template <class Function>
    int guarded(const Function &function)
    {
      try
        {
          return function();
        }
      catch (...)
        {
          thrown = std::current_exception();
          return unrecoverable;
        }
    }

    /// Throws what ARKODE's return value @p flag stands for.
    void check(const int flag)
    {
      if (thrown)
        std::rethrow_exception(std::exchange(thrown, nullptr));
      if (flag < 0)
        throw std::runtime_error(
          "ARKODE stopped at t = " + std::to_string(time) + " s: " + complaint);
    }

    static int rate(const double t, N_Vector y, N_Vector rate, void *data)
    {
      auto &self = *static_cast<Arkode *>(data);
      return self.guarded([&]() {
        self.problem.rate(t, values(y), values_of(rate));
        for (std::size_t i = 0; i < self.state.size(); ++i)
          if (!std::isfinite(values(rate)[i]))
            return not_a_number_code;
        return 0;
      });
    }

    static int jacobian_times(N_Vector     v,
                              N_Vector     Jv,
                              const double t,
                              N_Vector,
                              N_Vector,
                              void *data,
                              N_Vector)
    {
      auto &self = *static_cast<Arkode *>(data);
      return self.guarded([&]() {
        self.problem.jacobian_times(t, values(v), values_of(Jv));
        return 0;
      });
    }

    static int event(const double t, N_Vector y, double *value, void *data)
    {
      auto &self = *static_cast<Arkode *>(data);
      return self.guarded([&]() {
        *value = self.problem.event(t, values(y));
        return 0;
      });
    }

    static void note(int, const char *, const char *, char *text, void *data)
    {
      static_cast<Arkode *>(data)->complaint = text;
    }
  };



  OdeSolver::OdeSolver(const OdeProblem          &problem,
                       const double               start,
                       const std::vector<double> &initial,
                       const OdeTolerances       &tolerances)
    : arkode(std::make_unique<Arkode>(problem, start, initial))
  {
    Arkode    &a        = *arkode;
    const bool implicit = static_cast<bool>(problem.jacobian_times);
    a.check(SUNContext_Create(nullptr, &a.context));
    a.y      = N_VMake_Serial(a.state.size(), a.state.data(), a.context);
    a.memory = ARKStepCreate(implicit ? nullptr : Arkode::rate,
                             implicit ? Arkode::rate : nullptr,
                             start,
                             a.y,
                             a.context);
    if (a.memory == nullptr)
      throw std::runtime_error("ARKODE could not be set up");
    a.check(ARKStepSetErrHandlerFn(a.memory, Arkode::note, &a));
    a.check(ARKStepSetUserData(a.memory, &a));
    a.check(
      ARKStepSStolerances(a.memory, tolerances.relative, tolerances.absolute));
    a.check(ARKStepSetMaxNumSteps(a.memory, n_steps_max));
    a.check(
      ARKStepSetOrder(a.memory, implicit ? order_implicit : order_explicit));
    if (problem.event)
      a.check(ARKStepRootInit(a.memory, 1, Arkode::event));
    if (implicit)
      {
        a.solver =
          SUNLinSol_SPBCGS(a.y, SUN_PREC_NONE, n_krylov_steps, a.context);
        a.check(ARKStepSetLinearSolver(a.memory, a.solver, nullptr));
        a.check(ARKStepSetJacTimes(a.memory, nullptr, Arkode::jacobian_times));
        a.check(ARKStepSetLinear(a.memory, 0));
      }
  }

  OdeSolver::~OdeSolver() = default;



  bool OdeSolver::advance(const double t, const double limit)
  {
    if (t <= arkode->time)
      return false;
    arkode->check(ARKStepSetStopTime(arkode->memory, limit));
    const int flag =
      ARKStepEvolve(arkode->memory, t, arkode->y, &arkode->time, ARK_NORMAL);
    arkode->check(flag);
    return flag == ARK_ROOT_RETURN;
  }



  void OdeSolver::step(const double limit)
  {
    arkode->check(ARKStepSetStopTime(arkode->memory, limit));
    arkode->check(ARKStepEvolve(arkode->memory,
                                limit,
                                arkode->y,
                                &arkode->time,
                                ARK_ONE_STEP));
  }



  double OdeSolver::time() const
  {
    return arkode->time;
  }

  const std::vector<double> &OdeSolver::state() const
  {
    return arkode->state;
  }
} // namespace demold
