/* SPDX-FileCopyrightText: The Nephoscope authors */
/* SPDX-License-Identifier: BSD-3-Clause */
/* Preloaded into the ranks of tests, which are more than processors: Open MPI has a rank that waits yield its processor again and again, and it
   gets half of it back each time. Asleep it costs nothing. */
#include <sched.h>
#include <time.h>

int sched_yield(void)
{
  const struct timespec wait = { 0, 200000 };
  nanosleep(&wait, NULL);
  return 0;
}
