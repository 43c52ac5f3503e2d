// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The field of vtkRTAnalyticSource, smoothed and composited, as clouds.png.
#include <vtkCellCompositingMapper.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStructuredSmoothing.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

int main()
{
  vtkNew<vtkRTAnalyticSource> source;
  vtkNew<vtkStructuredSmoothing> smoothing;
  smoothing->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkCellCompositingMapper> mapper;
  mapper->SetInputConnection(smoothing->GetOutputPort());

  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(150, 0.5, 0.6, 0.8);
  color->AddRGBPoint(250, 1, 1, 1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(150, 0);
  opacity->AddPoint(250, 1);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(3);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.4);
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName("clouds.png");
  writer->Write();
  return 0;
}
