// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces of vtkSunlight, on several ranks: the clouds of all cast shadows on each. A piece of a
// grid is cut out of the whole, whose light each rank computes.
#include "vtkSunlight.h"

#include "DataSets.h"
#include "DefaultRange.h"
#include "InputBlocks.h"

#include "vtkDataSet.h"
#include "vtkExtentTranslator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using SDDP = vtkStreamingDemandDrivenPipeline;

// The data, and the clouds that shade them.
int vtkSunlight::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (input && nephoscope::IsStructured(input->Get(vtkDataObject::DATA_OBJECT())) &&
      input->Has(SDDP::WHOLE_EXTENT()))
    {
      int whole[6];
      input->Get(SDDP::WHOLE_EXTENT(), whole);
      input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
      input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
      input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      input->Set(SDDP::UPDATE_EXTENT(), whole, 6);
    }
  }
  return 1;
}

// As a source divides its grid into pieces.
void vtkSunlight::CropToPiece(vtkDataSet* data, vtkInformation* input, vtkInformation* output)
{
  const int pieces =
    output->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) ? output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) : 1;
  // Blocks of composite data are those of this rank alone.
  if (pieces < 2 || !nephoscope::IsStructured(this->GetInputDataObject(0, 0)) ||
    !input->Has(SDDP::WHOLE_EXTENT()))
  {
    return;
  }
  int* whole = input->Get(SDDP::WHOLE_EXTENT());
  if (!std::equal(whole, whole + 6, data->GetInformation()->Get(vtkDataObject::DATA_EXTENT())))
  {
    return;
  }
  const int piece = output->Get(SDDP::UPDATE_PIECE_NUMBER());
  const int ghosts = output->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  int part[6], own[6];
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(
    piece, pieces, ghosts, whole, part, translator->GetSplitMode(), 0);
  translator->PieceToExtentThreadSafe(piece, pieces, 0, whole, own, translator->GetSplitMode(), 0);
  data->Crop(part);
  if (ghosts > 0)
  {
    data->GenerateGhostArray(own);
  }
}

void vtkSunlight::WarnOfPieces(vtkDataSet* data, vtkInformation* information)
{
  // Parts of a surface have the shadows of all clouds if these are whole.
  vtkDataObject* shading = this->OnSurface ? this->ShadingClouds() : data;
  const bool inPieces = !nephoscope::RanksOfPieces(this) &&
    information->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) &&
    information->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1 && !nephoscope::IsStructured(shading);
  if (inPieces && !this->ToldOfPieces && information->Get(SDDP::UPDATE_PIECE_NUMBER()) == 0)
  {
    vtkWarningMacro(
      << nephoscope::InBlock(this, data)
      << "One of several pieces of unstructured data is requested, and it is lit alone: clouds of other pieces cast no shadow on it. For the light of all pieces, request "
         "the data as one piece, or make an image by Resample To Image first.");
  }
  this->ToldOfPieces = inPieces;
}
