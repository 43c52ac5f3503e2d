// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random numbers for property tests. The seed is fixed, so that a run can be repeated, and printed;
 * the environment variable NEPHOSCOPE_TEST_SEED replaces it.
 */
#ifndef nephoscope_TestRandom_h
#define nephoscope_TestRandom_h

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace nephoscope_test
{

class Random
{
public:
  explicit Random(unsigned long seed)
    : Engine(FromEnvironment(seed))
  {
  }

  double Uniform(double low = 0, double high = 1)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
  double Normal() { return std::normal_distribution<double>()(this->Engine); }
  /** Uniform in the logarithm. */
  double LogUniform(double low, double high) { return low * std::pow(high / low, this->Uniform()); }
  int Integer(int low, int high)
  {
    return std::uniform_int_distribution<int>(low, high)(this->Engine);
  }
  std::array<double, 3> NormalVector()
  {
    return { { this->Normal(), this->Normal(), this->Normal() } };
  }
  std::array<double, 3> Direction()
  {
    std::array<double, 3> v = this->NormalVector();
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return { { v[0] / length, v[1] / length, v[2] / length } };
  }
  std::mt19937_64& GetEngine() { return this->Engine; }

private:
  static unsigned long FromEnvironment(unsigned long seed)
  {
    const char* text = std::getenv("NEPHOSCOPE_TEST_SEED");
    seed = text ? std::stoul(text) : seed;
    std::cout << "NEPHOSCOPE_TEST_SEED=" << seed << std::endl;
    return seed;
  }
  std::mt19937_64 Engine;
};

} // namespace nephoscope_test

#endif
