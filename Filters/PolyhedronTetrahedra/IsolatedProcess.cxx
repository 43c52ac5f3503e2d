// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolatedProcess.h"

#if defined(__unix__) || defined(__APPLE__)

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace nephoscope
{
namespace
{
bool WriteAll(int file, const char* bytes, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t n = write(file, bytes, size);
    if (n < 0 && errno != EINTR)
    {
      return false;
    }
    bytes += n > 0 ? n : 0;
    size -= n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  return true;
}

// The host's handlers would print a trace, ask the user, or write a report.
void BecomeQuiet()
{
  for (const int signal : { SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGPIPE })
  {
    std::signal(signal, SIG_DFL);
  }
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void Serve(
  int file, int first, int count, const std::function<std::vector<char>(int)>& work)
{
  BecomeQuiet();
  for (int i = first; i < count; ++i)
  {
    const std::vector<char> bytes = work(i);
    const std::uint64_t size = bytes.size();
    if (!WriteAll(file, reinterpret_cast<const char*>(&size), sizeof size) ||
      !WriteAll(file, bytes.data(), bytes.size()))
    {
      break;
    }
  }
  _exit(0);
}

/** The parent's end. Reads until the deadline of the call at hand. */
class Reader
{
public:
  Reader(int file, double seconds, const std::function<bool()>& keepGoing)
    : File(file)
    , Seconds(seconds)
    , KeepGoing(keepGoing)
  {
  }

  // One result, or false with a reason (empty: the child has ended).
  bool Read(std::vector<char>& bytes, std::string& reason)
  {
    this->Deadline = Clock::now() +
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(this->Seconds));
    std::uint64_t size = 0;
    if (!this->ReadAll(reinterpret_cast<char*>(&size), sizeof size, reason))
    {
      return false;
    }
    bytes.resize(size);
    return this->ReadAll(bytes.data(), bytes.size(), reason);
  }

private:
  using Clock = std::chrono::steady_clock;

  bool ReadAll(char* bytes, std::size_t size, std::string& reason)
  {
    while (size > 0)
    {
      if (!this->Wait(reason))
      {
        return false;
      }
      const ssize_t n = read(this->File, bytes, size);
      if (n == 0 || (n < 0 && errno != EINTR))
      {
        return false;
      }
      bytes += n > 0 ? n : 0;
      size -= n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return true;
  }

  bool Wait(std::string& reason)
  {
    pollfd state = { this->File, POLLIN, 0 };
    while (poll(&state, 1, 100) <= 0)
    {
      if (!this->KeepGoing())
      {
        reason = "it was aborted";
        return false;
      }
      if (Clock::now() > this->Deadline)
      {
        reason = "it took longer than " + std::to_string(static_cast<int>(this->Seconds)) + " s";
        return false;
      }
    }
    return true;
  }

  int File;
  double Seconds;
  const std::function<bool()>& KeepGoing;
  Clock::time_point Deadline;
};

std::string Ending(pid_t child)
{
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(child, &status, 0)) < 0 && errno == EINTR)
  {
  }
  return ended == child && WIFSIGNALED(status)
    ? "it crashed (signal " + std::to_string(WTERMSIG(status)) + ")"
    : "it ended without a result";
}

// Runs the calls from `first` in one child; returns the number of the first call without a result.
int RunChild(int first, double seconds, const std::function<std::vector<char>(int)>& work,
  const std::function<bool()>& keepGoing, std::vector<IsolatedResult>& results, std::string& reason)
{
  const int count = static_cast<int>(results.size());
  int ends[2];
  if (pipe(ends) != 0)
  {
    reason = "there is no pipe for it";
    return first;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    Serve(ends[1], first, count, work);
  }
  close(ends[1]);
  if (child < 0)
  {
    close(ends[0]);
    reason = "no process could be started for it";
    return first;
  }
  Reader reader(ends[0], seconds, keepGoing);
  int next = first;
  while (next < count && reader.Read(results[static_cast<std::size_t>(next)].Bytes, reason))
  {
    ++next;
  }
  close(ends[0]);
  if (!reason.empty())
  {
    kill(child, SIGKILL);
  }
  const std::string end = Ending(child);
  reason = reason.empty() ? end : reason;
  return next;
}
}

std::vector<IsolatedResult> RunIsolated(int count, double seconds,
  const std::function<std::vector<char>(int)>& work, const std::function<bool()>& keepGoing)
{
  std::vector<IsolatedResult> results(static_cast<std::size_t>(count));
  for (int next = 0; next < count;)
  {
    std::string reason;
    next = RunChild(next, seconds, work, keepGoing, results, reason);
    if (next < count)
    {
      results[static_cast<std::size_t>(next)].Bytes.clear();
      results[static_cast<std::size_t>(next)].Failure = reason;
      ++next;
    }
    for (; next < count && !keepGoing(); ++next)
    {
      results[static_cast<std::size_t>(next)].Failure = "it was aborted";
    }
  }
  return results;
}

} // namespace nephoscope

#else

namespace nephoscope
{
std::vector<IsolatedResult> RunIsolated(int count, double,
  const std::function<std::vector<char>(int)>& work, const std::function<bool()>& keepGoing)
{
  std::vector<IsolatedResult> results(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    IsolatedResult& result = results[static_cast<std::size_t>(i)];
    if (keepGoing())
    {
      result.Bytes = work(i);
    }
    else
    {
      result.Failure = "it was aborted";
    }
  }
  return results;
}
} // namespace nephoscope

#endif
