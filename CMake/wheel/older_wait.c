/* SPDX-FileCopyrightText: The Nephoscope authors
 * SPDX-License-Identifier: BSD-3-Clause
 * As older_symbols.c, of the C++ library: std::condition_variable::wait(std::unique_lock<std::mutex>&). An object of its own, for the libraries that
 * use it alone. */
void older_wait(void* self, void* lock);
__asm__(
  ".symver older_wait,_ZNSt18condition_variable4waitERSt11unique_lockISt5mutexE@GLIBCXX_3.4.11"); /* newer: 3.4.30 */
void _ZNSt18condition_variable4waitERSt11unique_lockISt5mutexE(void* self, void* lock)
{
  older_wait(self, lock);
}
