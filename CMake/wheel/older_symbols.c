/* SPDX-FileCopyrightText: The Nephoscope authors
 * SPDX-License-Identifier: BSD-3-Clause
 * Functions that have got new versions in the C library lately, by their older ones: a library that is linked with this one runs on older
 * systems than that where it was built. Linked into the wheel's libraries alone. */
double older_hypot(double x, double y);
__asm__(".symver older_hypot,hypot@GLIBC_2.2.5"); /* newer: 2.35 */
double hypot(double x, double y)
{
  return older_hypot(x, y);
}
