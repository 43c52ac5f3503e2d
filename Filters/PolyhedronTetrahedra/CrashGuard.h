// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs a function of a C library so that a failed assertion or an invalid access in it comes back as an answer.
 *
 * Debian's TetGen is built with assertions, which end the process; a cell that is out of the ordinary must not take ParaView
 * with it. POSIX lets a handler of SIGABRT or SIGSEGV leave by siglongjmp when the signal was raised by the thread's own
 * call. What the call had allocated is lost. Elsewhere than on POSIX systems the function runs unguarded.
 */
#ifndef CrashGuard_h
#define CrashGuard_h

#if defined(__unix__) || defined(__APPLE__)
#include <csetjmp>
#include <csignal>
#define NEPHOSCOPE_GUARDS_CRASHES 1
#endif

namespace nephoscope
{

#ifdef NEPHOSCOPE_GUARDS_CRASHES

class CrashGuard
{
public:
  /** 0, or the signal that ended the call. `call` must not throw. Not to be nested. */
  template <typename Call>
  static int Run(Call call)
  {
    struct sigaction ours = {};
    ours.sa_handler = &CrashGuard::Leave;
    sigemptyset(&ours.sa_mask);
    struct sigaction before[2];
    sigaction(SIGABRT, &ours, &before[0]);
    sigaction(SIGSEGV, &ours, &before[1]);
    Before() = before;
    const int signal = sigsetjmp(Place(), 1);
    if (signal == 0)
    {
      Inside() = true;
      call();
    }
    Inside() = false;
    sigaction(SIGABRT, &before[0], nullptr);
    sigaction(SIGSEGV, &before[1], nullptr);
    return signal;
  }

private:
  static sigjmp_buf& Place()
  {
    static sigjmp_buf place;
    return place;
  }
  static struct sigaction*& Before()
  {
    static struct sigaction* before = nullptr;
    return before;
  }
  // Another thread that crashes meanwhile has nothing to do with the call.
  static bool& Inside()
  {
    static thread_local bool inside = false;
    return inside;
  }
  static void Leave(int signal)
  {
    if (Inside())
    {
      siglongjmp(Place(), signal);
    }
    sigaction(signal, &Before()[signal == SIGABRT ? 0 : 1], nullptr);
    raise(signal);
  }
};

#else

class CrashGuard
{
public:
  template <typename Call>
  static int Run(Call call)
  {
    call();
    return 0;
  }
};

#endif

} // namespace nephoscope

#endif
