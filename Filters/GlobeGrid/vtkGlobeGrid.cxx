// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGlobeGrid.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGlobeGrid);
vtkGlobeGrid::vtkGlobeGrid(){ this->SetNumberOfInputPorts(2);}
void vtkGlobeGrid::PrintSelf(ostream& os, vtkIndent indent){this->Superclass::PrintSelf(os,indent);}
void vtkGlobeGrid::SetWindArrayNames(const std::string& a,const std::string& b,const std::string& c){this->SetEastwardWindArrayName(a);this->SetNorthwardWindArrayName(b);this->SetVerticalWindArrayName(c);}
int vtkGlobeGrid::FillInputPortInformation(int,vtkInformation*){return 1;}
int vtkGlobeGrid::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*){return 1;}
int vtkGlobeGrid::RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*){return 1;}
int vtkGlobeGrid::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*){return 1;}
