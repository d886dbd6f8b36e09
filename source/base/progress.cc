// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/progress.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lamella
{
  namespace
  {
    // Seconds without a line, seconds from one to the next, and characters of
    // one, which must not go on into the next line of a terminal.
    constexpr double      silence = 3., pause = 0.5;
    constexpr std::size_t width = 79;

    /// Where a stream has its progress.
    int
    place_of_progress()
    {
      static const int place = std::ios_base::xalloc();
      return place;
    }



    std::string
    duration(const double seconds)
    {
      constexpr double minute = 60., few = 2.;
      return seconds < few * minute ?
               std::to_string(std::lround(std::ceil(seconds))) + " s" :
               std::to_string(std::lround(seconds / minute)) + " min";
    }
  } // namespace



  Progress::Progress(std::ostream &terminal, Clock clock_)
    : terminal(terminal)
    , clock(std::move(clock_))
    , gate(*this)
    , out(&gate)
    , born(clock())
    , drawn_at(born)
  {
    out.pword(place_of_progress()) = this;
  }



  Progress::~Progress()
  {
    erase();
    terminal.flush();
  }



  double
  Progress::steady_seconds()
  {
    return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }



  Progress *
  Progress::of(std::ostream &out)
  {
    return static_cast<Progress *>(out.pword(place_of_progress()));
  }



  // ---- what is done

  Progress::Part::Part(std::ostream               &out,
                       const std::string          &name,
                       const std::optional<double> work)
    : of(Progress::of(out))
  {
    if (of == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(of->guard);
    const double                      now = of->clock();
    of->levels.push_back({name, work, 0., 0., now, now});
  }



  Progress::Part::~Part()
  {
    if (of == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(of->guard);
    if (const double rate = of->levels.back().rate(); rate > 0.)
      of->last_rate = rate;
    of->levels.pop_back();
  }



  double
  Progress::Level::rate() const
  {
    return work && changed > began ? done / (changed - began) : 0.;
  }



  Progress::Level *
  Progress::counted()
  {
    const auto found =
      std::find_if(levels.rbegin(), levels.rend(), [](const Level &level) {
        return level.work.has_value();
      });
    return found == levels.rend() ? nullptr : &*found;
  }



  void
  Progress::done(std::ostream &out, const double work)
  {
    Progress *const progress = of(out);
    if (progress == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(progress->guard);
    if (Level *const level = progress->counted())
      {
        level->done += work;
        level->changed = progress->clock();
      }
  }



  void
  Progress::expect(std::ostream &out, const double more)
  {
    Progress *const progress = of(out);
    if (progress == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(progress->guard);
    if (Level *const level = progress->counted())
      *level->work += more;
  }



  // ---- how it is told

  std::string
  Progress::state_of(const Level &level, const double rate, const double now)
  {
    constexpr double percent = 100., least_left = 1.;
    std::string      text;
    if (level.work && level.done > 0.)
      text = ", " + std::to_string(int(percent * level.shown)) + " %";
    const double left =
      rate > 0. && level.work ?
        (*level.work - level.done) / rate - (now - level.changed) :
        0.;
    return text + (left >= least_left ?
                     ", about " + duration(left) + " left" :
                     ", " + duration(now - level.began) + " so far");
  }



  std::string
  Progress::line(const double now, const std::size_t room)
  {
    if (levels.empty())
      return "";
    Level *const level = counted();
    if (level != nullptr && *level->work > 0.)
      level->shown =
        std::max(level->shown, std::min(1., level->done / *level->work));
    const double      own = level == nullptr ? 0. : level->rate();
    const std::string end = state_of(level == nullptr ? levels.front() : *level,
                                     own > 0. ? own : last_rate,
                                     now);
    if (end.size() >= room)
      return "";
    // Inner parts say more: they are what stays where there is no room.
    std::string names;
    for (auto part = levels.rbegin(); part != levels.rend(); ++part)
      if (!part->name.empty())
        {
          const std::string more =
            names.empty() ? part->name : part->name + ": " + names;
          if (!names.empty() && more.size() + end.size() > room)
            break;
          names = more;
        }
    if (names.size() + end.size() > room)
      {
        std::size_t length = room - end.size();
        // Not within a character of several bytes.
        while (length > 0 && (names[length] & 0xC0) == 0x80)
          --length;
        names.resize(length);
      }
    return names.empty() ? "" : names + end;
  }



  void
  Progress::draw()
  {
    const std::lock_guard<std::mutex> lock(guard);
    const double                      now = clock();
    if (now - born < silence || now - drawn_at < pause)
      return;
    const std::string indent = partial.empty() ? "  " : "";
    const std::size_t taken  = partial.size() + indent.size();
    const std::string text   = taken < width ? line(now, width - taken) : "";
    drawn_at                 = now;
    if (text.empty())
      return erase();
    const std::size_t before = drawn;
    drawn                    = indent.size() + text.size();
    terminal << '\r' << partial << indent << text
             << std::string(before > drawn ? before - drawn : 0, ' ')
             << std::flush;
    drawn = std::max(drawn, before);
  }



  void
  Progress::erase()
  {
    if (drawn > 0)
      terminal << '\r' << partial << std::string(drawn, ' ') << '\r' << partial;
    drawn = 0;
  }



  Progress::Gate::int_type
  Progress::Gate::overflow(const int_type c)
  {
    if (traits_type::eq_int_type(c, traits_type::eof()))
      return traits_type::not_eof(c);
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? c : traits_type::eof();
  }



  std::streamsize
  Progress::Gate::xsputn(const char *const text, const std::streamsize count)
  {
    const std::lock_guard<std::mutex> lock(progress.guard);
    progress.erase();
    progress.partial.append(text, count);
    if (const auto end = progress.partial.rfind('\n'); end != std::string::npos)
      progress.partial.erase(0, end + 1);
    return progress.terminal.write(text, count) ? count : 0;
  }



  int
  Progress::Gate::sync()
  {
    const std::lock_guard<std::mutex> lock(progress.guard);
    return progress.terminal.flush() ? 0 : -1;
  }



  // ---- who draws it

  ProgressDrawing::ProgressDrawing(Progress                    &progress,
                                   const std::function<bool()> &is_seen)
    : thread([this, &progress, is_seen] {
      std::unique_lock<std::mutex> lock(guard);
      while (!woken.wait_for(lock,
                             std::chrono::duration<double>(pause),
                             [this] { return ended; }))
        if (is_seen())
          progress.draw();
    })
  {}



  ProgressDrawing::~ProgressDrawing()
  {
    {
      const std::lock_guard<std::mutex> lock(guard);
      ended = true;
    }
    woken.notify_all();
    thread.join();
  }
} // namespace lamella
