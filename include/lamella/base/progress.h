// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_progress_h
#define lamella_base_progress_h

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <thread>
#include <vector>

namespace lamella
{
  /**
   * What is done of what is to be done, as the last line of a terminal:
   *
   *   load step 3 of 10, 42 %, about 12 s left
   *
   * the names of the parts that are at work, the outermost first, then of the
   * innermost one that is counted the share done / work, and the time that the
   * rest takes, (work - done) / rate. Its rate is that of what it has done; of
   * a part that has not done anything that of the one counted before it; where
   * there is none the line says the seconds so far. Work is in operations
   * wherever these are known; who makes a part says in what else. A share never
   * falls, and is 100 % at most, however wrong a prediction was.
   *
   * Everything else goes to output(), which erases the line first; a line that
   * is not ended yet stays, and the names come behind it. Other streams share a
   * progress by copyfmt(): those of models whose words nobody wants to read,
   * say. Streams without one take all of this and do nothing.
   *
   * One thread works, and another one may draw() meanwhile.
   */
  class Progress
  {
  public:
    /// Seconds since whatever moment.
    using Clock = std::function<double()>;

    /// Onto @p terminal, which is referred to and nobody else writes to as long
    /// as this lives.
    explicit Progress(std::ostream &terminal, Clock clock = steady_seconds);
    Progress(const Progress &) = delete;
    /// Erases the line.
    ~Progress();

    /// For everything else.
    std::ostream &
    output()
    {
      return out;
    }

    /// Draws the line, unless this is less than three seconds old or drew less
    /// than half a second ago.
    void
    draw();

    /// Of the progress of @p out adds @p work to what the innermost counted
    /// part has done.
    static void
    done(std::ostream &out, const double work);

    /// Its whole work is @p more than was thought, less where that is negative.
    static void
    expect(std::ostream &out, const double more);

    static double
    steady_seconds();

    /// A part of the work, as long as the object lives. The last one made goes
    /// first.
    class Part
    {
    public:
      /// Of the progress of @p out; @p name may be empty, @p work is what it
      /// takes, if it is counted.
      Part(std::ostream               &out,
           const std::string          &name,
           const std::optional<double> work = {});
      Part(const Part &) = delete;
      ~Part();

    private:
      Progress *const of;
    };

  private:
    struct Level
    {
      std::string           name;
      std::optional<double> work;
      double                done = 0., shown = 0.;
      /// When it began, and when something of it was done last.
      double began = 0., changed = 0.;

      double
      rate() const;
    };

    /// Erases the line and hands on what is written.
    class Gate : public std::streambuf
    {
    public:
      explicit Gate(Progress &progress)
        : progress(progress)
      {}

    protected:
      int_type
      overflow(int_type c) override;
      std::streamsize
      xsputn(const char *text, std::streamsize count) override;
      int
      sync() override;

    private:
      Progress &progress;
    };

    static Progress *
    of(std::ostream &out);
    Level *
    counted();
    /// The line without its indentation, in @p room characters; empty if there
    /// is nothing to say or it does not fit.
    std::string
    line(const double now, const std::size_t room);
    /// Of @p level at the time @p now: share and time, as the line ends.
    static std::string
    state_of(const Level &level, const double rate, const double now);
    void
    erase();

    std::ostream &terminal;
    Clock         clock;
    Gate          gate;
    std::ostream  out;

    std::mutex         guard;
    std::vector<Level> levels;
    /// Of the last part that was counted.
    double last_rate = 0.;
    double born, drawn_at;
    /// What is written of a line that is not ended, and the length of what is
    /// drawn behind it.
    std::string partial;
    std::size_t drawn = 0;
  };

  /// Has a progress drawn twice a second, as long as it lives, by a thread of
  /// its own: a factorisation does not come by to do it.
  class ProgressDrawing
  {
  public:
    /// @p progress is referred to, and drawn while @p is_seen.
    ProgressDrawing(Progress &progress, const std::function<bool()> &is_seen);
    ~ProgressDrawing();

  private:
    std::mutex              guard;
    std::condition_variable woken;
    bool                    ended = false;
    std::thread             thread;
  };
} // namespace lamella

#endif
