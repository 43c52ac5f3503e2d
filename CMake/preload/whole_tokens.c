/* SPDX-FileCopyrightText: The Nephoscope authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Preloaded into the hosts, it lets VTK before 9.3.1 read its own XML files beside a recent libexpat.
 *
 * VTK gives expat a file in pieces and stops at the element that begins raw binary data. Since 2.6.0, and in the
 * security updates of 2.5.0 in Debian 12, expat waits for more input before it reports such an element, so VTK
 * hands it binary data as text: "not well-formed (invalid token)", and the data set comes out empty. ParaView moves
 * unstructured data between ranks in that form, so a picture from two ranks lacks cells. See VTK issue 19258.
 * Each parser that VTK creates is told not to wait. Python's parsers are created by another function. */
#define _GNU_SOURCE
#include <dlfcn.h>

typedef void* (*CreateFunction)(const char* encoding);
typedef unsigned char (*SetDeferralFunction)(void* parser, unsigned char enabled);

void* XML_ParserCreate(const char* encoding)
{
  CreateFunction create;
  SetDeferralFunction set_deferral;
  void* parser;
  /* A function pointer through void*, as POSIX tells to use dlsym. */
  *(void**)&create = dlsym(RTLD_NEXT, "XML_ParserCreate");
  *(void**)&set_deferral = dlsym(RTLD_NEXT, "XML_SetReparseDeferralEnabled");
  parser = create ? create(encoding) : 0;
  if (parser && set_deferral)
  {
    set_deferral(parser, 0);
  }
  return parser;
}
