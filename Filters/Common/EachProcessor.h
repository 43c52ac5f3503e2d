// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * NEPHOSCOPE_FOR_EACH_PROCESSOR, before a function, compiles it twice, with everything it calls inlined: for any processor, and for those
 * with wide registers and fused multiplication. The choice is made when the library is loaded. Sanitizers are not ready then.
 */
#ifndef nephoscope_EachProcessor_h
#define nephoscope_EachProcessor_h

#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define NEPHOSCOPE_FOR_EACH_PROCESSOR \
  __attribute__((target_clones("arch=x86-64-v3", "default"), flatten))
#else
#define NEPHOSCOPE_FOR_EACH_PROCESSOR
#endif

#endif
