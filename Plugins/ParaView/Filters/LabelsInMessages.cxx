// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelsInMessages.h"

#include "ClassesOfSuite.h"
#include "PanelWords.h"

#include "vtkCellCompositingRepresentation.h"
#include "vtkCloudOptics.h"
#include "vtkCloudSurface.h"
#include "vtkCloudTextureRepresentation.h"
#include "vtkCloudsOverGlobe.h"
#include "vtkContourCellSplitter.h"
#include "vtkGlobeGrid.h"
#include "vtkGlobeTerrain.h"
#include "vtkHazeRepresentation.h"
#include "vtkPVFlowVolume.h"
#include "vtkPolyhedronToTetrahedra.h"
#include "vtkRankMessages.h"
#include "vtkSmokePuffs.h"
#include "vtkSparseVolumeReader.h"
#include "vtkSparseVolumeWriter.h"
#include "vtkStructuredSmoothing.h"
#include "vtkSunRepresentation.h"
#include "vtkSunSource.h"
#include "vtkSunlight.h"
#include "vtkTextureCoordinateAdvection.h"
#include "vtkTexturedSplatsRepresentation.h"

#include "vtkCallbackCommand.h"
#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkNew.h"

namespace nephoscope
{
namespace
{
void Print(vtkObject* caller, unsigned long event, void*, void* message)
{
  const std::string text =
    InWordsOfPanel(message ? static_cast<const char*>(message) : "", caller->GetClassName());
  vtkRankMessages::Tell(event, text);
}

// What proxies call to make an object.
template <class Class>
vtkObjectBase* Make(void*)
{
  Class* object = Class::New();
  vtkNew<vtkCallbackCommand> printer;
  printer->SetCallback(Print);
  object->AddObserver(vtkCommand::ErrorEvent, printer);
  object->AddObserver(vtkCommand::WarningEvent, printer);
  return object;
}

void Register(vtkClientServerInterpreter* interpreter)
{
#define NEPHOSCOPE_MAKE(CLASS) \
  interpreter->AddNewInstanceFunction(#CLASS "WithLabels", Make<CLASS>);
  NEPHOSCOPE_FOR_CLASSES_OF_SUITE(NEPHOSCOPE_MAKE)
#undef NEPHOSCOPE_MAKE
}
}

void SayLabelsInMessages()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(Register);
}

} // namespace nephoscope
