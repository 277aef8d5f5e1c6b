// SPDX-License-Identifier: LGPL-2.1-or-later
// Direct solution by MUMPS, with inertia and sign of the determinant.
#include "solution/mumps.h"

#include "solution/gather_on_root.h"

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <dmumps_c.h>

#include <algorithm>
#include <string>
#include <vector>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// MUMPS' job numbers.
    enum Job
    {
      initialise = -1,
      finalise   = -2,
      analyse    = 1,
      factorise  = 2,
      substitute = 3
    };
  } // namespace

  struct Mumps::Implementation
  {
    Implementation(MPI_Comm communicator, bool symmetric);
    ~Implementation();

    /// Control and information arrays by the numbers in the User's Guide.
    int &icntl(int i)
    {
      return mumps.icntl[i - 1];
    }
    int infog(int i) const
    {
      return mumps.infog[i - 1];
    }
    void run(Job job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
    }

    bool read_entries(const Epetra_CrsMatrix &matrix);
    void hand_over_entries();
    void analyse_pattern();
    void factorise_with_enough_memory();

    MPI_Comm            communicator;
    bool                symmetric;
    unsigned int        n_ranks, rank;
    DMUMPS_STRUC_C      mumps;
    std::vector<int>    rows, columns; // entries of this rank, counted from 1
    std::vector<double> values;
    bool                analysed         = false;
    bool                zero_on_diagonal = false;
    unsigned int        n_analyses       = 0;
    Status              status           = Status::failed;

    GatherOnRoot        on_root;
    std::vector<double> right_hand_side; // only on rank 0, then the solution
  };


  Mumps::Implementation::Implementation(const MPI_Comm communicator,
                                        const bool     symmetric)
    : communicator(communicator)
    , symmetric(symmetric)
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , mumps{}
  {
    mumps.sym          = symmetric ? 2 : 0;
    mumps.par          = 1;
    mumps.comm_fortran = MPI_Comm_c2f(communicator);
    run(initialise);
    for (const int messages : {1, 2, 3, 4})
      icntl(messages) = 0;
    // METIS, in Debian's build PORD. METIS by PERM_IN would save 10 to 33 % of
    // the flops from 16^3 elements on, but cost 16 to 40 % more in the plane.
    icntl(7)  = 5;
    icntl(10) = 0;  // no iterative refinement
    icntl(13) = 1;  // no ScaLAPACK at the root: it would hide the inertia there
    icntl(14) = 30; // work space beyond the estimate [%]
    icntl(18) = n_ranks > 1 ? 3 : 0; // entries from all ranks or from one
    icntl(24) = 1;                   // find null pivots ...
    mumps.cntl[3 - 1] = 1e-13; // ... which are this small once scaled to one
    icntl(28)         = 1;     // sequential analysis
    icntl(33)         = symmetric ? 0 : 1; // determinant
  }


  Mumps::Implementation::~Implementation()
  {
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (finalized == 0)
      run(finalise);
  }


  /// Copies the values; the positions only where they differ from before.
  /// Returns whether they, or the zeros on the diagonal, do on any rank.
  bool Mumps::Implementation::read_entries(const Epetra_CrsMatrix &matrix)
  {
    const int *const  row_ids    = matrix.RowMap().MyGlobalElements();
    const int *const  column_ids = matrix.ColMap().MyGlobalElements();
    const std::size_t n_before   = rows.size();
    bool              changed    = false;
    bool              has_zero   = false;
    std::size_t       k          = 0;
    values.resize(matrix.NumMyNonzeros());
    rows.resize(std::max(n_before, values.size()));
    columns.resize(rows.size());
    for (int i = 0; i < matrix.NumMyRows(); ++i)
      {
        const int row = row_ids[i] + 1;
        int       n_entries;
        double   *row_values;
        int      *row_columns;
        double    diagonal = 0.;
        matrix.ExtractMyRowView(i, n_entries, row_values, row_columns);
        for (int j = 0; j < n_entries; ++j)
          {
            const int column = column_ids[row_columns[j]] + 1;
            if (column == row)
              diagonal = row_values[j];
            if (symmetric && column > row)
              continue;
            changed     = changed || rows[k] != row || columns[k] != column;
            rows[k]     = row;
            columns[k]  = column;
            values[k++] = row_values[j];
          }
        has_zero = has_zero || diagonal == 0.;
      }
    values.resize(k);
    rows.resize(k);
    columns.resize(k);

    const int mine[2] = {changed || k != n_before, has_zero};
    int       any[2];
    MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, communicator);
    const bool pivoting_changed = zero_on_diagonal != (any[1] != 0);
    zero_on_diagonal            = (any[1] != 0);
    return any[0] != 0 || pivoting_changed;
  }


  void Mumps::Implementation::hand_over_entries()
  {
    if (n_ranks > 1)
      {
        mumps.nnz_loc = values.size();
        mumps.irn_loc = rows.data();
        mumps.jcn_loc = columns.data();
        mumps.a_loc   = values.data();
      }
    else
      {
        mumps.nnz = values.size();
        mumps.irn = rows.data();
        mumps.jcn = columns.data();
        mumps.a   = values.data();
      }
  }


  void Mumps::Implementation::analyse_pattern()
  {
    // A matching of rows and columns pays where pivots may vanish; elsewhere
    // it only makes the ordering depend on the values.
    icntl(6)  = zero_on_diagonal ? 7 : 0;
    icntl(12) = zero_on_diagonal ? 0 : 1;
    run(analyse);
    analysed = infog(1) >= 0;
    ++n_analyses;
  }


  void Mumps::Implementation::factorise_with_enough_memory()
  {
    const int usual = icntl(14);
    run(factorise);
    for (unsigned int i = 0; i < 6; ++i)
      {
        const int error = infog(1);
        // work arrays or message buffers too small for the pivots met
        if (error != -8 && error != -9 && error != -14 && error != -15 &&
            error != -17 && error != -20)
          break;
        icntl(14) *= 2;
        run(factorise);
      }
    icntl(14) = usual;
  }


  Mumps::Mumps(const MPI_Comm communicator, const bool symmetric)
    : implementation(std::make_unique<Implementation>(communicator, symmetric))
  {}


  Mumps::~Mumps() = default;


  Mumps::Status
  Mumps::analyse_and_factorise(const TrilinosWrappers::SparseMatrix &matrix)
  {
    Implementation         &m               = *implementation;
    const Epetra_CrsMatrix &epetra          = matrix.trilinos_matrix();
    const bool              pattern_changed = m.read_entries(epetra);
    m.hand_over_entries();
    if (pattern_changed || !m.analysed)
      {
        m.mumps.n = epetra.NumGlobalRows();
        m.on_root.reinit(m.communicator, epetra.RowMap());
        m.analyse_pattern();
      }
    if (m.analysed)
      m.factorise_with_enough_memory();

    const int error = m.infog(1);
    if (error >= 0)
      m.status = m.infog(28) > 0 ? Status::singular : Status::ok;
    else if (error == -6 || error == -10)
      m.status = Status::singular;
    else if (error == -7 || error == -8 || error == -9 || error == -13 ||
             error == -19)
      m.status = Status::out_of_memory;
    else
      m.status = Status::failed;
    return m.status;
  }


  void Mumps::solve(TrilinosWrappers::MPI::Vector       &x,
                    const TrilinosWrappers::MPI::Vector &b)
  {
    Implementation &m = *implementation;
    AssertThrow(m.status == Status::ok,
                ExcMessage("There is no factor to solve with."));
    AssertDimension(x.locally_owned_size(), b.locally_owned_size());
    m.on_root.gather(b.trilinos_vector()[0], m.right_hand_side);
    m.mumps.rhs = m.right_hand_side.data();
    m.run(substitute);
    AssertThrow(m.infog(1) >= 0,
                ExcMessage("MUMPS could not solve, INFOG(1) = " +
                           std::to_string(m.infog(1))));
    m.on_root.scatter(m.right_hand_side, x.trilinos_vector()[0]);
  }


  int Mumps::n_negative_pivots() const
  {
    const Implementation &m = *implementation;
    return m.symmetric && m.status == Status::ok ? m.infog(12) : -1;
  }


  int Mumps::determinant_sign() const
  {
    const Implementation &m = *implementation;
    if (m.status != Status::ok)
      return 0;
    if (m.symmetric)
      return m.infog(12) % 2 == 0 ? 1 : -1;
    return m.mumps.rinfog[12 - 1] > 0. ? 1 : -1;
  }


  double Mumps::memory() const
  {
    // MUMPS counts in millions of bytes.
    return implementation->infog(22) * 1e6 / (1024. * 1024.);
  }


  unsigned int Mumps::n_analyses() const
  {
    return implementation->n_analyses;
  }


  int Mumps::error_code() const
  {
    return implementation->infog(1);
  }
} // namespace demold
