// SPDX-License-Identifier: LGPL-2.1-or-later
// The console: one line per increment with an estimate of the time left.
#ifndef demold_output_progress_h
#define demold_output_progress_h

#include <chrono>
#include <limits>
#include <ostream>
#include <string>

namespace demold
{
  class Summary;

  /// What one line says. NaN is printed as "-": not every step has a force or
  /// a bond.
  struct IncrementLine
  {
    double       time            = 0.; ///< [s]
    double       opening         = 0.; ///< travel of the mould [mm]
    double       force           = 0.; ///< in the opening direction [N]
    unsigned int iterations      = 0;  ///< Newton iterations
    double       bonded_fraction = std::numeric_limits<double>::quiet_NaN();
    std::string  strategy;
    double       done = 0.; ///< share of the run that is behind us, 0 to 1
  };

  /// @p seconds as "42 s", "3 min 20 s" or "2 h 05 min"; "-" if unknown.
  std::string duration_text(const double seconds);

  /// Seconds left [s] when the share of the run behind us has grown from
  /// @p done_at_start to @p done within @p elapsed [s]; NaN if unknown.
  double seconds_left(const double done_at_start,
                      const double done,
                      const double elapsed);

  /// Prints lines to @p out unless @p quiet.
  class Progress
  {
  public:
    /// @p done_at_start is the share of the run a restart has skipped.
    Progress(std::ostream &out,
             const bool    quiet,
             const double  done_at_start = 0.);

    /// A line, with a header above every twentieth.
    void print(const IncrementLine &line);

    /// A remark between the lines: a rejected increment, a jump, a long set-up.
    /// An empty text prints nothing.
    void note(const std::string &text);

    /// The table at the end.
    void print(const Summary &summary);

  private:
    std::ostream                         &out;
    const bool                            quiet;
    const double                          done_at_start;
    std::chrono::steady_clock::time_point start;
    unsigned int                          n_lines = 0;
  };
} // namespace demold

#endif
