// SPDX-License-Identifier: LGPL-2.1-or-later
// Differential-algebraic equations with controlled error, by SUNDIALS IDA.
#include "rig/dae_solver.h"

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace demold
{
  namespace
  {
    constexpr long n_steps_max   = 1000000;
    constexpr int  shorter_step  = 1;
    constexpr int  unrecoverable = -1;
  } // namespace



  /// Owns what the C interface hands out. Not copied: IDA keeps its address.
  struct DaeSolver::Ida
  {
    DaeProblem          problem;
    double              time = 0.;
    std::vector<double> state, rate, is_differential;
    std::string         complaint;
    long                n_steps_before = 0; // of the starts before this one
    SUNContext          context        = nullptr;
    N_Vector            y = nullptr, yp = nullptr, id = nullptr;
    void               *memory = nullptr;
    SUNMatrix           matrix = nullptr;
    SUNLinearSolver     solver = nullptr;

    Ida(const DaeProblem &problem, const std::vector<double> &initial)
      : problem(problem)
      , state(initial)
      , rate(initial.size(), 0.)
    {
      for (const bool differential : problem.differential)
        is_differential.push_back(differential ? 1. : 0.);
    }
    Ida(const Ida &) = delete;

    ~Ida()
    {
      if (memory != nullptr)
        IDAFree(&memory);
      if (solver != nullptr)
        SUNLinSolFree(solver);
      if (matrix != nullptr)
        SUNMatDestroy(matrix);
      for (const N_Vector v : {y, yp, id})
        if (v != nullptr)
          N_VDestroy(v);
      if (context != nullptr)
        SUNContext_Free(&context);
    }

    void check(const int flag) const
    {
      if (flag < 0)
        throw std::runtime_error("IDA stopped at t = " + std::to_string(time) +
                                 " s: " + complaint);
    }

    /// What is algebraic, and all rates, follow from what is differential.
    void make_consistent(const double next)
    {
      check(IDACalcIC(memory, IDA_YA_YDP_INIT, next));
      check(IDAGetConsistentIC(memory, y, yp));
    }

    static int
    residual(const double t, N_Vector y, N_Vector yp, N_Vector r, void *data)
    {
      const auto &self = *static_cast<Ida *>(data);
      try
        {
          double *const values = N_VGetArrayPointer(r);
          if (!self.problem.residual(t,
                                     N_VGetArrayPointer(y),
                                     N_VGetArrayPointer(yp),
                                     values))
            return shorter_step;
          for (std::size_t i = 0; i < self.state.size(); ++i)
            if (!std::isfinite(values[i]))
              return shorter_step;
          return 0;
        }
      catch (...) // must not pass through C
        {
          return unrecoverable;
        }
    }

    static void note(int, const char *, const char *, char *text, void *data)
    {
      static_cast<Ida *>(data)->complaint = text;
    }
  };



  DaeSolver::DaeSolver(const DaeProblem          &problem,
                       const std::vector<double> &initial,
                       const double               next)
    : ida(std::make_unique<Ida>(problem, initial))
  {
    Ida       &i = *ida;
    const auto n = static_cast<sunindextype>(i.state.size());
    i.check(SUNContext_Create(nullptr, &i.context));
    i.y      = N_VMake_Serial(n, i.state.data(), i.context);
    i.yp     = N_VMake_Serial(n, i.rate.data(), i.context);
    i.id     = N_VMake_Serial(n, i.is_differential.data(), i.context);
    i.memory = IDACreate(i.context);
    if (i.memory == nullptr)
      throw std::runtime_error("IDA could not be set up");
    i.check(IDASetErrHandlerFn(i.memory, Ida::note, &i));
    i.check(IDAInit(i.memory, Ida::residual, 0., i.y, i.yp));
    i.check(IDASetUserData(i.memory, &i));
    i.check(IDASetId(i.memory, i.id));
    i.check(IDASStolerances(i.memory,
                            problem.relative_tolerance,
                            problem.absolute_tolerance));
    i.check(IDASetMaxNumSteps(i.memory, n_steps_max));
    i.matrix = SUNDenseMatrix(n, n, i.context);
    i.solver = SUNLinSol_Dense(i.y, i.matrix, i.context);
    i.check(IDASetLinearSolver(i.memory, i.solver, i.matrix));
    i.make_consistent(next);
  }

  DaeSolver::~DaeSolver() = default;



  void DaeSolver::advance(const double t, const double limit)
  {
    if (t <= ida->time)
      return;
    ida->check(IDASetStopTime(ida->memory, limit));
    ida->check(
      IDASolve(ida->memory, t, &ida->time, ida->y, ida->yp, IDA_NORMAL));
  }

  void DaeSolver::restart(const double next)
  {
    ida->n_steps_before = n_steps();
    ida->check(IDAReInit(ida->memory, ida->time, ida->y, ida->yp));
    ida->make_consistent(next);
  }

  const std::vector<double> &DaeSolver::state() const
  {
    return ida->state;
  }

  long DaeSolver::n_steps() const
  {
    long n = 0;
    ida->check(IDAGetNumSteps(ida->memory, &n));
    return ida->n_steps_before + n;
  }
} // namespace demold
