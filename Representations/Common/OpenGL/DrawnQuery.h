// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Reports whether any fragment was drawn in its scope, without counting. */
#ifndef nephoscope_DrawnQuery_h
#define nephoscope_DrawnQuery_h

#include "OpenGLFunctions.h"

namespace nephoscope
{

class DrawnQuery
{
public:
  DrawnQuery()
  {
    glGenQueries(1, &this->Id);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, this->Id);
  }
  ~DrawnQuery() { glDeleteQueries(1, &this->Id); }
  DrawnQuery(const DrawnQuery&) = delete;
  DrawnQuery& operator=(const DrawnQuery&) = delete;

  bool End()
  {
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    GLuint any = 0;
    glGetQueryObjectuiv(this->Id, GL_QUERY_RESULT, &any);
    return any != 0;
  }

private:
  GLuint Id = 0;
};

} // namespace nephoscope

#endif
