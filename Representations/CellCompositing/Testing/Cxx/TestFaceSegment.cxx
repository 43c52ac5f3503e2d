// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments of signed length: steps that take each other back, and sums that do not depend on the
// order.
#include "FaceSegment.h"

#include "SegmentReference.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <vector>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
double Advance(double light, const SegmentStep<double>& step, double near, double far)
{
  return step.Transparency * light + step.Near * near + step.Far * far;
}

struct Face
{
  double Z, Extinction, Color;
  int Mark; // 1: the ray leaves the volume there, seen from the eye; -1: it enters
};

/** Light of one channel after all faces, drawn in the order given, over `light`. */
double Sweep(const std::vector<Face>& faces, double light, bool average)
{
  int crossings = 0;
  Face last = {};
  for (const Face& face : faces)
  {
    if (crossings != 0)
    {
      const Face &near = face.Z < last.Z ? face : last, &far = face.Z < last.Z ? last : face;
      const double length = crossings * (last.Z - face.Z), size = std::fabs(length);
      light = Advance(light,
        FaceSegmentStep(size * near.Extinction, size * far.Extinction, length < 0, average),
        near.Color, far.Color);
    }
    last = face;
    crossings += face.Mark;
  }
  EXPECT_EQ(crossings, 0);
  return light;
}

/** Back to front: a volume from 9 to 6 and, after a gap, from 4 to 1. */
std::vector<Face> VolumeWithGap(Random& random, bool varying)
{
  const auto face = [&](double z, int mark) {
    return Face{ z, varying ? random.Uniform(0, 3) : 0.7, varying ? random.Uniform() : 0.4, mark };
  };
  std::vector<Face> faces;
  for (const double high : { 9.0, 4.0 })
  {
    faces.push_back(face(high, 1));
    for (double z = high; (z -= random.Uniform(0.1, 0.9)) > high - 3;)
    {
      faces.push_back(face(z, 0));
    }
    faces.push_back(face(high - 3, -1));
  }
  return faces;
}
}

TEST(FaceSegment, ForwardStepIsTheOpticalSegment)
{
  constexpr double promised = 6e-7; // the bound that ChooseQuadratureRule keeps
  Random random(41);
  for (int i = 0; i < 2000; ++i)
  {
    const double tf = random.LogUniform(1e-6, 20), tb = random.LogUniform(1e-6, 20);
    const SegmentStep<double> step = FaceSegmentStep(tf, tb, false, false);
    const ReferenceWeights weights = FindReferenceWeights(tf, tb);
    EXPECT_NEAR(step.Near, double(weights.Front), promised);
    EXPECT_NEAR(step.Far, double(weights.Back), promised);
    EXPECT_NEAR(step.Transparency, std::exp(-0.5 * (tf + tb)), 1e-15);
  }
}

TEST(FaceSegment, BackwardStepTakesBack)
{
  Random random(42);
  for (int i = 0; i < 2000; ++i)
  {
    const bool average = i % 2 == 0;
    const double tNear = random.LogUniform(1e-6, 5), tFar = random.LogUniform(1e-6, 5);
    const double light = random.Uniform(), near = random.Uniform(), far = random.Uniform();
    const double forward = Advance(light, FaceSegmentStep(tNear, tFar, false, average), near, far);
    const auto back = FaceSegmentStep(tNear, tFar, true, average);
    EXPECT_GT(back.Transparency, 1);
    EXPECT_NEAR(Advance(forward, back, near, far), light, 1e-13 * back.Transparency);
  }
}

TEST(FaceSegment, OneMediumInAnyOrder)
{
  Random random(43);
  for (int i = 0; i < 300; ++i)
  {
    std::vector<Face> faces = VolumeWithGap(random, false);
    const double light = random.Uniform(), through = std::exp(-0.7 * 6);
    const double expected = through * light + (1 - through) * 0.4;
    EXPECT_NEAR(Sweep(faces, light, i % 2 == 0), expected, 1e-13);
    std::shuffle(faces.begin(), faces.end(), random.GetEngine());
    EXPECT_NEAR(Sweep(faces, light, i % 2 == 0), expected, 1e-9) << "shuffled";
  }
}

TEST(FaceSegment, VaryingMediumInTheRightOrderOnly)
{
  Random random(44);
  int wrong = 0;
  for (int i = 0; i < 100; ++i)
  {
    std::vector<Face> faces = VolumeWithGap(random, true);
    double expected = 1;
    for (std::size_t k = 1; k < faces.size(); ++k)
    {
      const Face &back = faces[k - 1], &front = faces[k];
      if (back.Mark != -1)
      {
        const double length = back.Z - front.Z;
        const ReferenceWeights w =
          FindReferenceWeights(length * front.Extinction, length * back.Extinction);
        expected = double(1 - w.Front - w.Back) * expected + double(w.Front) * front.Color +
          double(w.Back) * back.Color;
      }
    }
    EXPECT_NEAR(Sweep(faces, 1, false), expected, 1e-6);
    std::swap(faces[1], faces[2]);
    wrong += std::fabs(Sweep(faces, 1, false) - expected) > 1e-6;
  }
  EXPECT_GT(wrong, 50);
}

/**
 * Extinction and colour linear in z: going back and forth is the same integral, whatever the order
 * between first and last.
 */
TEST(FaceSegment, LinearMediumInAnyOrderInside)
{
  Random random(45);
  for (int i = 0; i < 200; ++i)
  {
    const double rate = random.Uniform(0, 1), slope = random.Uniform(0, 0.3),
                 hue = random.Uniform(-0.1, 0.1);
    const auto face = [&](double z, int mark) {
      return Face{ z, rate + slope * z, 0.5 + hue * z, mark };
    };
    std::vector<Face> faces = { face(4, 1) };
    for (int k = 0; k < 6; ++k)
    {
      faces.push_back(face(random.Uniform(1, 4), 0));
    }
    faces.push_back(face(1, -1));
    const double expected = Sweep({ faces.front(), faces.back() }, 0.3, false);
    EXPECT_NEAR(Sweep(faces, 0.3, false), expected, 3e-6);
  }
}

TEST(FaceSegment, ThickStepsStayFinite)
{
  for (const double tau : { 299.0, 301.0, 1e6, 1e300 })
  {
    const auto forward = FaceSegmentStep(tau, tau, false, false),
               backward = FaceSegmentStep(tau, tau, true, false);
    EXPECT_NEAR(forward.Near + forward.Far, 1, 1e-15);
    EXPECT_TRUE(std::isfinite(backward.Transparency) && std::isfinite(backward.Near) &&
      std::isfinite(backward.Far));
  }
  const auto nothing = FaceSegmentStep(0.0, 0.0, false, false);
  EXPECT_EQ(nothing.Transparency, 1);
  EXPECT_EQ(nothing.Near, 0);
}
