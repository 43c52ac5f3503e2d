// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRankMessages
 * @brief messages of several ranks, each sentence once
 *
 * The first rank shows its messages at once; the others keep theirs. Flush, which ParaView calls on
 * all ranks, makes the first rank show those of the others that it has not shown itself, with the
 * numbers of their ranks. Sentences that differ only in numbers are the same one.
 */
#ifndef vtkRankMessages_h
#define vtkRankMessages_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for messages

class vtkSMProxy;

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkRankMessages : public vtkObject
{
public:
  static vtkRankMessages* New();
  vtkTypeMacro(vtkRankMessages, vtkObject);

  /** Shows or keeps the text of an error or a warning. */
  static void Tell(unsigned long event, const std::string& text);

  /** Collective. */
  void Flush();

  /**
   * On the client: flushes after updates of a source, or pictures of a view, if the server has
   * several ranks.
   */
  static void Follow(vtkSMProxy* sourceOrView);

protected:
  vtkRankMessages() = default;
  ~vtkRankMessages() override = default;

private:
  vtkRankMessages(const vtkRankMessages&) = delete;
  void operator=(const vtkRankMessages&) = delete;
};

#endif
