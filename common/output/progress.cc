// SPDX-License-Identifier: LGPL-2.1-or-later
// The console: one line per increment with an estimate of the time left.
#include "output/progress.h"

#include "output/summary.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace demold
{
  namespace
  {
    constexpr unsigned int lines_per_header = 20;

    std::string number_text(const double value, const int digits = 5)
    {
      if (!std::isfinite(value))
        return "-";
      std::ostringstream text;
      text << std::setprecision(digits) << value;
      return text.str();
    }



    std::string percent_text(const double share)
    {
      return std::isfinite(share) ? number_text(100. * share, 4) + " %" : "-";
    }



    void put(std::ostream &out, const int width, const std::string &text)
    {
      out << std::setw(width) << text;
    }
  } // namespace



  std::string duration_text(const double seconds)
  {
    if (!std::isfinite(seconds) || seconds < 0.)
      return "-";
    if (seconds > 3.6e9) // beyond anyone's patience, and beyond an integer
      return "> 1000000 h";
    const long total   = std::lround(seconds);
    const long hours   = total / 3600;
    const long minutes = total / 60 % 60;

    std::ostringstream text;
    text << std::setfill('0');
    if (hours > 0)
      text << hours << " h " << std::setw(2) << minutes << " min";
    else if (minutes > 0)
      text << minutes << " min " << std::setw(2) << total % 60 << " s";
    else
      text << total << " s";
    return text.str();
  }



  double seconds_left(const double done_at_start,
                      const double done,
                      const double elapsed)
  {
    if (!(done > done_at_start))
      return std::numeric_limits<double>::quiet_NaN();
    return elapsed * std::max(0., 1. - done) / (done - done_at_start);
  }



  Progress::Progress(std::ostream &out,
                     const bool    quiet,
                     const double  done_at_start)
    : out(out)
    , quiet(quiet)
    , done_at_start(done_at_start)
    , start(std::chrono::steady_clock::now())
  {}



  void Progress::print(const IncrementLine &line)
  {
    if (quiet)
      return;
    const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();

    std::ostringstream text;
    if (n_lines++ % lines_per_header == 0)
      {
        put(text, 11, "time [s]");
        put(text, 13, "opening [mm]");
        put(text, 12, "force [N]");
        put(text, 6, "iter");
        put(text, 9, "bonded");
        text << "  " << std::left << std::setw(14) << "strategy" << std::right;
        put(text, 12, "time left");
        text << '\n';
      }
    put(text, 11, number_text(line.time));
    put(text, 13, number_text(line.opening));
    put(text, 12, number_text(line.force));
    put(text, 6, std::to_string(line.iterations));
    put(text, 9, percent_text(line.bonded_fraction));
    text << "  " << std::left << std::setw(14) << line.strategy << std::right;
    put(text,
        12,
        duration_text(seconds_left(done_at_start, line.done, elapsed)));
    out << text.str() << std::endl; // flushed: someone is watching
  }



  void Progress::note(const std::string &text)
  {
    if (!quiet && !text.empty())
      out << "  " << text << std::endl;
  }



  void Progress::print(const Summary &summary)
  {
    if (quiet)
      return;
    out << '\n';
    summary.print(out);
  }
} // namespace demold
