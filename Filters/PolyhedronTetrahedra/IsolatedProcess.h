// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs calls into a library that may crash or hang so that the process survives it.
 *
 * TetGen 1.5 ends the process at failed assertions, and where it throws an error it frees its
 * memory twice, since terminatetetgen() does so before the destructors of the unwinding do; no
 * handler in the process can mend a heap after that. So the calls are made in a child process, one
 * after another, which sends each result back through a pipe. A child that dies or takes too long
 * costs the call at hand, and another child goes on with the next.
 *
 * The child is a copy of the process (fork) that does nothing else, prints nothing, leaves no core
 * file and runs no exit handlers. Without fork, the calls run in the process itself.
 */
#ifndef nephoscope_IsolatedProcess_h
#define nephoscope_IsolatedProcess_h

#include <functional>
#include <string>
#include <vector>

namespace nephoscope
{

struct IsolatedResult
{
  std::vector<char> Bytes;
  std::string Failure; ///< empty, or what became of the call
};

/**
 * Calls work(0) ... work(count - 1), each of which may take `seconds`. `keepGoing` is called
 * several times a second; when it returns false, the remaining calls fail.
 */
std::vector<IsolatedResult> RunIsolated(int count, double seconds,
  const std::function<std::vector<char>(int)>& work, const std::function<bool()>& keepGoing);

} // namespace nephoscope

#endif
