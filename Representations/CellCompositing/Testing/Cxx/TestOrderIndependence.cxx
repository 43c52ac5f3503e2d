// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// When a medium has one colour, so that its cells need no order.
#include "OrderIndependence.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <limits>

using nephoscope::IsOfOneColor;
using nephoscope::OneColor;
using Channels = nephoscope::TransferFunctionTable::Channels;

namespace
{
// The scalar goes from 0 to 10, in the table from 0 to 1.
class OneColorOf : public ::testing::Test
{
protected:
  OneColorOf()
  {
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
    this->Opacity->AddPoint(0, 0.2);
    this->Opacity->AddPoint(10, 0.7);
  }

  bool Ask(Channels channels = Channels::ColorAndOpacity, float low = 0, float high = 1)
  {
    const double range[2] = { 0, 10 };
    nephoscope::TransferFunctionTable table;
    table.Build(this->Property, range, channels);
    return IsOfOneColor(table, low, high);
  }

  void Opacities(std::initializer_list<std::pair<double, double>> points)
  {
    this->Opacity->RemoveAllPoints();
    for (const auto& point : points)
    {
      this->Opacity->AddPoint(point.first, point.second);
    }
  }

  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkVolumeProperty> Property;
};
}

TEST_F(OneColorOf, AConstantFunction)
{
  this->Color->AddRGBPoint(3, 0.3, 0.6, 0.9);
  EXPECT_TRUE(this->Ask()) << "one point";
  this->Color->AddRGBPoint(7, 0.3, 0.6, 0.9);
  EXPECT_TRUE(this->Ask()) << "two points inside the range";
  EXPECT_TRUE(this->Ask(Channels::Color));
}

TEST_F(OneColorOf, AFunctionThatChanges)
{
  this->Color->AddRGBPoint(0, 1, 1, 1);
  this->Color->AddRGBPoint(10, 1, 1, 0.99);
  EXPECT_FALSE(this->Ask());
  EXPECT_FALSE(this->Ask(Channels::Color));
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0, 1, 1, 1);
  this->Color->AddRGBPoint(4.99, 1, 1, 1);
  this->Color->AddRGBPoint(5, 0, 1, 1);
  this->Color->AddRGBPoint(5.01, 1, 1, 1);
  EXPECT_FALSE(this->Ask()) << "a narrow peak";
}

TEST_F(OneColorOf, WhatLiesOutsideTheRangeDoesNotCount)
{
  this->Color->AddRGBPoint(-5, 0, 0, 0);
  this->Color->AddRGBPoint(-1, 1, 1, 1);
  this->Color->AddRGBPoint(11, 1, 1, 1);
  this->Color->AddRGBPoint(12, 0, 0, 0);
  EXPECT_TRUE(this->Ask());
  this->Color->AddRGBPoint(-1, 0, 1, 1); // reaches into the range on its way to 11
  EXPECT_FALSE(this->Ask());
  EXPECT_TRUE(this->Ask(Channels::Color, 0.5f, 0.5f)) << "a single scalar";
}

TEST_F(OneColorOf, BothEndsOfTheRangeCount)
{
  this->Color->AddRGBPoint(0, 1, 1, 1);
  this->Color->AddRGBPoint(9, 1, 1, 1);
  this->Color->AddRGBPoint(10, 0, 1, 1);
  EXPECT_FALSE(this->Ask()) << "the high end";
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0, 0, 1, 1);
  this->Color->AddRGBPoint(1, 1, 1, 1);
  EXPECT_FALSE(this->Ask()) << "the low end";
}

TEST_F(OneColorOf, WhatIsTransparentDoesNotCount)
{
  this->Color->AddRGBPoint(0, 0, 0, 1);
  this->Color->AddRGBPoint(4, 1, 1, 1);
  this->Color->AddRGBPoint(10, 1, 1, 1);
  EXPECT_FALSE(this->Ask());
  this->Opacities({ { 0, 0 }, { 4, 0 }, { 10, 1 } });
  EXPECT_TRUE(this->Ask());
  EXPECT_FALSE(this->Ask(Channels::Color)) << "opacity from another array may be anything";
  this->Opacities({ { 0, 0 }, { 3.5, 0 }, { 10, 1 } });
  EXPECT_FALSE(this->Ask()) << "the colour changes up to 4";
  this->Opacities({ { 0, 0 }, { 10, 0 } });
  EXPECT_TRUE(this->Ask()) << "nothing is seen at all";
}

// VTK's way there and back through other colour spaces is not exact: 2e-5 in Lab, seen where the
// function ends inside the range.
TEST_F(OneColorOf, OneColorInAnyColorSpace)
{
  for (const auto& rgb : { std::array<double, 3>{ { 1, 1, 1 } }, { { 0.8, 0.5, 0.1 } },
         { { 0.05, 0.4, 0.95 } }, { { 0, 0, 0 } } })
  {
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0, rgb[0], rgb[1], rgb[2]);
    this->Color->AddRGBPoint(4, rgb[0], rgb[1], rgb[2]);
    this->Color->AddRGBPoint(9, rgb[0], rgb[1], rgb[2]);
    for (const int space :
      { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING, VTK_CTF_STEP })
    {
      this->Color->SetColorSpace(space);
      EXPECT_TRUE(this->Ask()) << "colour space " << space << ", red " << rgb[0];
    }
    this->Color->SetColorSpaceToRGB();
  }
}

TEST_F(OneColorOf, Gray)
{
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0, 0.5);
  gray->AddPoint(10, 0.5);
  this->Property->SetColor(gray);
  EXPECT_TRUE(this->Ask());
  gray->AddPoint(5, 0.6);
  EXPECT_FALSE(this->Ask());
}

TEST(OneColor, NotANumberIsNoColor)
{
  OneColor colors;
  EXPECT_TRUE(colors.IsOne());
  colors.Add({ { 1, 0, 0, 1 } });
  EXPECT_TRUE(colors.IsOne());
  colors.Add({ { std::numeric_limits<float>::quiet_NaN(), 0, 0, 1 } });
  EXPECT_FALSE(colors.IsOne());
  colors.Add({ { 1, 0, 0, 1 } });
  EXPECT_FALSE(colors.IsOne());
}
