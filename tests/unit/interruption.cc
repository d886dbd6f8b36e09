// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>

#include <boost/test/unit_test.hpp>

#include <csignal>
#include <functional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

BOOST_AUTO_TEST_SUITE(interruption)

using namespace lamella;

namespace
{
  /// What a process that does @p work says, both outputs, and the signal that
  /// ends it.
  std::pair<std::string, int>
  outcome_of_process(const std::function<void()> &work)
  {
    int both[2];
    BOOST_REQUIRE(pipe(both) == 0);
    const pid_t child = fork();
    if (child == 0)
      {
        dup2(both[1], STDERR_FILENO);
        close(both[0]);
        // Not the handlers of the tests.
        for (const int signal : {SIGINT, SIGTERM})
          std::signal(signal, SIG_DFL);
        work();
        _exit(0);
      }
    close(both[1]);
    std::string said;
    char        c;
    while (read(both[0], &c, 1) == 1)
      said += c;
    close(both[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return {said, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  }



  void
  say(const std::string &what)
  {
    BOOST_REQUIRE(write(STDERR_FILENO, what.data(), what.size()) > 0);
  }
} // namespace



BOOST_AUTO_TEST_CASE(words_are_said_and_the_signal_ends_it)
{
  for (const int signal : {SIGINT, SIGTERM})
    {
      const auto [said, by] = outcome_of_process([signal] {
        set_interruption_message("these.");
        raise(signal);
        say("not ended");
      });
      BOOST_TEST(said == "\nlamella: these.\n");
      BOOST_TEST(by == signal);
    }
}

BOOST_AUTO_TEST_CASE(what_is_being_written_is_written)
{
  const auto [said, by] = outcome_of_process([] {
    set_interruption_message("nothing.");
    {
      const SignalBlock whole;
      {
        const SignalBlock part;
        raise(SIGINT);
      }
      say("written");
      set_interruption_message("all.");
    }
    say("not ended");
  });
  BOOST_TEST(said == "written\nlamella: all.\n");
  BOOST_TEST(by == SIGINT);
}

BOOST_AUTO_TEST_CASE(a_second_signal_does_not_wait)
{
  const auto [said, by] = outcome_of_process([] {
    set_interruption_message("nothing.");
    const SignalBlock whole;
    raise(SIGINT);
    raise(SIGINT);
    say("not ended");
  });
  BOOST_TEST(said == "");
  BOOST_TEST(by == SIGINT);
}

BOOST_AUTO_TEST_SUITE_END()
