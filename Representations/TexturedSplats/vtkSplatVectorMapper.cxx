// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSplatVectorMapper.h"

#include "vtkScalarsToColors.h"

#include <cmath>

vtkSplatVectorMapper::vtkSplatVectorMapper() = default;
vtkSplatVectorMapper::~vtkSplatVectorMapper() = default;

void vtkSplatVectorMapper::SetVectorColorFunction(vtkScalarsToColors* function)
{
  if (this->VectorColorFunction != function)
  {
    this->VectorColorFunction = function;
    this->Modified();
  }
}

vtkScalarsToColors* vtkSplatVectorMapper::GetVectorColorFunction()
{
  return this->VectorColorFunction;
}

double vtkSplatVectorMapper::GetPatternPeriod() const
{
  return this->VectorStyle == SEGMENTS ? this->SegmentLength : this->StreakPeriod;
}

void vtkSplatVectorMapper::SetFilmTime(double time)
{
  if (!std::isfinite(time))
  {
    vtkErrorMacro("The time of the film cannot be " << time << ": it must be finite.");
  }
  else if (time != this->FilmTime)
  {
    this->FilmTime = time;
    this->Modified();
  }
}

void vtkSplatVectorMapper::ShallowCopy(vtkAbstractMapper* other)
{
  this->Superclass::ShallowCopy(other);
  auto* mapper = vtkSplatVectorMapper::SafeDownCast(other);
  if (!mapper || mapper == this)
  {
    return;
  }
  this->SetVectorArrayName(mapper->VectorArrayName);
  this->SetVectorOpacity(mapper->VectorOpacity);
  this->SetMaximumSpeed(mapper->MaximumSpeed);
  this->SetVectorStyle(mapper->VectorStyle);
  this->SetVectorPlacement(mapper->VectorPlacement);
  this->SetLayerAxis(mapper->LayerAxis);
  this->SetVectorUnit(mapper->VectorUnit);
  this->SetVectorFraction(mapper->VectorFraction);
  this->SetStreakPeriod(mapper->StreakPeriod);
  this->SetStreakWidth(mapper->StreakWidth);
  this->SetSegmentLength(mapper->SegmentLength);
  this->SetSegmentWidth(mapper->SegmentWidth);
  this->SetVectorColorArrayName(mapper->VectorColorArrayName);
  this->SetUseVectorColor(mapper->UseVectorColor);
  this->SetPhase(mapper->Phase);
  this->SetPhaseCycles(mapper->PhaseCycles);
  this->SetPhaseSteps(mapper->PhaseSteps);
  this->SetTrueSpeed(mapper->TrueSpeed);
  this->SetTimeScale(mapper->TimeScale);
  this->SetFilmTime(mapper->FilmTime);
  this->SetVectorColorFunction(mapper->VectorColorFunction);
  this->SetVectorColor(mapper->VectorColor);
}

void vtkSplatVectorMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorArrayName: " << this->VectorArrayName << "\n";
  os << indent << "VectorOpacity: " << this->VectorOpacity << "\n";
  os << indent << "MaximumSpeed: " << this->MaximumSpeed << "\n";
  os << indent << "StreakPeriod: " << this->StreakPeriod << "\n";
  os << indent << "VectorStyle: " << (this->VectorStyle == SEGMENTS ? "Segments" : "Streaks")
     << "\n";
  os << indent
     << "VectorPlacement: " << (this->VectorPlacement == PLACEMENT_LAYERS ? "Layers" : "Middle")
     << "\n";
  os << indent << "LayerAxis: " << this->LayerAxis << "\n";
  os << indent << "VectorUnit: " << this->VectorUnit << "\n";
  os << indent << "VectorFraction: " << this->VectorFraction << "\n";
  os << indent << "StreakWidth: " << this->StreakWidth << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "SegmentWidth: " << this->SegmentWidth << "\n";
  os << indent << "VectorColorArrayName: " << this->VectorColorArrayName << "\n";
  os << indent << "VectorColorFunction: " << this->VectorColorFunction.Get() << "\n";
  os << indent << "PhaseSteps: " << this->PhaseSteps << "\n";
  os << indent << "VectorColor: " << this->VectorColor[0] << " " << this->VectorColor[1] << " "
     << this->VectorColor[2] << "\n";
  os << indent << "UseVectorColor: " << this->UseVectorColor << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "PhaseCycles: " << this->PhaseCycles << "\n";
  os << indent << "TrueSpeed: " << this->TrueSpeed << "\n";
  os << indent << "TimeScale: " << this->TimeScale << "\n";
  os << indent << "FilmTime: " << this->FilmTime << "\n";
}
