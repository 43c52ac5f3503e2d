// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Threads that stay, for work of thousands of short loops: vtkSMPTools with threads of our own
 * would start them anew for each. Between two loops they wait in a spin of some microseconds, then
 * asleep. The loop goes on without those who are late.
 */
#ifndef nephoscope_ThreadTeam_h
#define nephoscope_ThreadTeam_h

#include "OwnThreads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace nephoscope
{

class ThreadTeam
{
public:
  /** As many threads as vtkSMPTools would have; the caller is one of them. */
  ThreadTeam()
    : ThreadTeam(OwnNumber())
  {
  }

  explicit ThreadTeam(int threads)
  {
    for (int i = 1; i < threads; ++i)
    {
      this->Helpers.emplace_back([this]() { this->Serve(); });
    }
  }

  ~ThreadTeam()
  {
    this->Ends = true;
    this->Begin();
    for (std::thread& helper : this->Helpers)
    {
      helper.join();
    }
  }

  ThreadTeam(const ThreadTeam&) = delete;
  void operator=(const ThreadTeam&) = delete;

  /** Calls body(0) to body(count - 1), which must not call Run. From one thread at a time. */
  void Run(int count, const std::function<void(int)>& body)
  {
    if (this->Helpers.empty() || count < 2)
    {
      for (int i = 0; i < count; ++i)
      {
        body(i);
      }
      return;
    }
    this->Body = &body;
    this->Count = count;
    this->Next = 0;
    this->Open = true;
    this->Begin();
    this->Take();
    this->Open = false;
    while (this->Inside > 0)
    {
      std::this_thread::yield();
    }
  }

private:
  static int OwnNumber()
  {
    int number = 1;
    WithThreads([&number]() { number = vtkSMPTools::GetEstimatedNumberOfThreads(); });
    return number;
  }

  void Begin()
  {
    ++this->Loop;
    if (this->Asleep > 0)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Wake.notify_all();
    }
  }

  void Take()
  {
    for (int i = this->Next++; i < this->Count; i = this->Next++)
    {
      (*this->Body)(i);
    }
  }

  // Who is inside before the loop is closed is waited for; who comes later finds it closed.
  void Serve()
  {
    for (unsigned served = 0; !this->Ends;)
    {
      served = this->AwaitLoopAfter(served);
      ++this->Inside;
      if (this->Open)
      {
        this->Take();
      }
      --this->Inside;
    }
  }

  unsigned AwaitLoopAfter(unsigned served)
  {
    const auto patience =
      std::chrono::steady_clock::now() + std::chrono::microseconds(200); // some starts of a thread
    while (this->Loop == served && std::chrono::steady_clock::now() < patience)
    {
      std::this_thread::yield();
    }
    if (this->Loop == served)
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      ++this->Asleep;
      this->Wake.wait(lock, [this, served]() { return this->Loop != served; });
      --this->Asleep;
    }
    return this->Loop;
  }

  std::atomic<unsigned> Loop{ 0 };
  std::atomic<int> Next{ 0 }, Inside{ 0 }, Asleep{ 0 };
  std::atomic<bool> Open{ false }, Ends{ false };
  const std::function<void(int)>* Body = nullptr;
  int Count = 0;
  std::mutex Mutex;
  std::condition_variable Wake;
  std::vector<std::thread> Helpers; // last: they use all others
};

} // namespace nephoscope

#endif
