// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <unistd.h>

namespace lamella
{
  namespace
  {
    struct Words
    {
      std::array<char, 1024> text = {};
      std::size_t            size = 0;
    };

    // Two of them, so that those which a handler may read are never written.
    std::array<Words, 2>       both;
    std::atomic<const Words *> spoken{nullptr};

    // How many SignalBlock there are, and the signal that waits for them.
    std::atomic<int> n_uninterrupted{0}, waiting{0};

    static_assert(std::atomic<const Words *>::is_always_lock_free &&
                    std::atomic<int>::is_always_lock_free,
                  "what a signal handler reads must not wait");



    /// Calls nothing but what a signal handler may call.
    extern "C" void
    handle_signal(const int signal)
    {
      // This order is safe: this sees no writing, or the writer the signal.
      waiting = signal;
      if (n_uninterrupted > 0)
        return;
      if (const Words *words = spoken.load())
        if (write(STDERR_FILENO, words->text.data(), words->size) < 0)
          _exit(128 + signal);
      // The handler is gone by now (SA_RESETHAND), so this ends the program.
      raise(signal);
    }



    void
    install_handler()
    {
      struct sigaction action = {};
      action.sa_handler       = handle_signal;
      action.sa_flags         = SA_RESETHAND;
      sigemptyset(&action.sa_mask);
      for (const int signal : {SIGINT, SIGTERM})
        {
          struct sigaction before = {};
          sigaction(signal, nullptr, &before);
          // Who has it ignored (nohup, a background job) means that.
          if (before.sa_handler != SIG_IGN)
            sigaction(signal, &action, nullptr);
        }
    }
  } // namespace



  void
  set_interruption_message(const std::string &words)
  {
    Words            &next = spoken.load() == &both[0] ? both[1] : both[0];
    const std::string line = words.empty() ? "" : "\nlamella: " + words + "\n";
    next.size              = std::min(line.size(), next.text.size());
    std::copy_n(line.begin(), next.size, next.text.begin());
    spoken.store(&next);
    static const bool installed = (install_handler(), true);
    static_cast<void>(installed);
  }



  SignalBlock::SignalBlock()
  {
    ++n_uninterrupted;
  }



  SignalBlock::~SignalBlock()
  {
    if (--n_uninterrupted == 0 && waiting != 0)
      handle_signal(waiting);
  }
} // namespace lamella
