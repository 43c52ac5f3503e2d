// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Calls that crash, hang or end the process cost themselves and nothing else.
#include "IsolatedProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <unistd.h>

using namespace nephoscope;

namespace
{
std::vector<char> Answer(int i)
{
  return std::vector<char>(static_cast<std::size_t>(1000 * i), static_cast<char>('a' + i));
}
bool Always()
{
  return true;
}
}

TEST(IsolatedProcess, ReturnsWhatTheCallsReturn)
{
  const auto results = RunIsolated(20, 10, Answer, Always);
  ASSERT_EQ(results.size(), 20u);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(results[static_cast<std::size_t>(i)].Failure, "");
    EXPECT_EQ(results[static_cast<std::size_t>(i)].Bytes, Answer(i));
  }
}

TEST(IsolatedProcess, SurvivesCrashesEndsAndHangs)
{
  const auto results = RunIsolated(
    8, 0.5,
    [](int i) {
      if (i == 1)
      {
        std::abort();
      }
      if (i == 3)
      {
        raise(SIGSEGV);
      }
      if (i == 4)
      {
        std::this_thread::sleep_for(std::chrono::seconds(60));
      }
      if (i == 7)
      {
        _exit(0);
      }
      return Answer(i);
    },
    Always);
  const char* failures[] = { "", "crashed", "", "crashed", "took longer", "", "", "ended" };
  for (int i = 0; i < 8; ++i)
  {
    const IsolatedResult& result = results[static_cast<std::size_t>(i)];
    const bool failed = failures[i][0] != 0;
    EXPECT_EQ(result.Failure.empty(), !failed) << i << ": " << result.Failure;
    EXPECT_NE(result.Failure.find(failures[i]), std::string::npos) << i << ": " << result.Failure;
    EXPECT_EQ(result.Bytes, failed ? std::vector<char>() : Answer(i));
  }
}

TEST(IsolatedProcess, CanBeAborted)
{
  int asked = 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto results = RunIsolated(
    5, 60,
    [](int) {
      std::this_thread::sleep_for(std::chrono::seconds(60));
      return std::vector<char>();
    },
    [&]() { return ++asked < 3; });
  for (const IsolatedResult& result : results)
  {
    EXPECT_NE(result.Failure.find("abort"), std::string::npos);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}
