// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The balance of diffuse light: what the sun's beam, the sky and the ground bring into the box
 * around a point equals what leaves the box or is absorbed.
 * Fluxes between points are those of Eddington's approximation, exact in each layer
 * (LayerTransfer.h), plus what discrete ordinates find different in layers thin enough for them. So
 * light is conserved for any optical depth of cells. Plain C++17.
 */
#ifndef nephoscope_LightBalance_h
#define nephoscope_LightBalance_h

#include "BeamDeposit.h"
#include "ColumnSolver.h"
#include "LightGrid.h"

#include <vector>

namespace nephoscope
{
/**
 * Fluence, flux along the axes, flux up plus flux down, and the second moment of the diffuse light:
 * the integral of P2(z), a Legendre polynomial, over directions. Tilt: the integrals of x z and y
 * z.
 */
struct DiffuseField
{
  std::vector<float> Fluence;
  std::vector<Vector> Flux;
  std::vector<float> Vertical;
  std::vector<float> SecondMoment;
  std::vector<std::array<float, 2>> Tilt;

  void Clear(std::size_t points);
  float Up(std::size_t p) const { return 0.5f * (this->Vertical[p] + this->Flux[p][2]); }
  float Down(std::size_t p) const { return 0.5f * (this->Vertical[p] - this->Flux[p][2]); }
};

class LightBalance
{
public:
  LightBalance(const LightGrid& grid, const BeamDeposit& deposit, const Parallel& parallel);

  /**
   * Makes `field` the balanced one: by Eddington's approximation alone, or with what `ordinates`
   * find different.
   */
  void Solve(const DiffuseField* ordinates, DiffuseField& field, double reduction);

  /**
   * After the last Solve: light down on bright ground in balance, too, which would not converge in
   * between; light below 0 at top and ground is taken from the columns beside.
   */
  void Finish(DiffuseField& field) const;

  /** Power absorbed in the box around each point, per volume. */
  std::vector<float> Absorption() const;

private:
  struct Edge // between a point and the next one along an axis; powers
  {
    float Here = 0, There = 0;   // conductances
    float First = 0, Second = 0; // what the beam brings to the points
    float Lost = 0;              // what the beam leaves in the layer, beside these
    float Area = 0;
    float Trust = 0;   // in discrete ordinates
    float Forward = 0; // albedo times asymmetry
    float Extra = 0;   // what they find different

    double Out(double here, double there) const
    {
      return this->Here * here - this->There * there - this->First + this->Extra;
    }
    double In(double here, double there) const
    {
      return this->There * here - this->Here * there + this->Second + this->Extra;
    }
  };
  struct Boundary // at top, ground and open sides; power that leaves is Rate times fluence, less
                  // Source
  {
    float Rate = 0, Source = 0, Area = 0, Trust = 0, Extra = 0;
    double Out(double fluence) const { return this->Rate * fluence - this->Source + this->Extra; }
  };
  using Index = std::array<int, 3>;

  template <typename Body>
  void ForPoints(Body body) const;
  std::size_t Neighbour(std::size_t p, const Index& at, int axis, int next) const
  {
    return p + next * this->Grid.Stride(axis) - at[axis] * this->Grid.Stride(axis);
  }
  static double HeightOf(const LightGrid& grid);
  double WidthAt(std::size_t p, const Index& at, int axis) const;
  double AreaAt(std::size_t p, const Index& at, int axis) const;
  double LayerDepth(std::size_t p) const;
  /** Calls body(axis, 1 or -1 outwards along it, boundary) where a point is on an open side. */
  template <typename Balance, typename Body>
  static void ForSides(Balance& balance, const Index& at, Body body)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      if (balance.Grid.IsOpenSide(at[axis], axis))
      {
        const std::size_t row = std::size_t(at[2]) * balance.Grid.Size[1 - axis] + at[1 - axis];
        const bool isLast = at[axis] > 0;
        body(axis, isLast ? 1 : -1, balance.Sides[axis][2 * row + (isLast ? 1 : 0)]);
      }
    }
  }
  struct LayerMedium Between(std::size_t p, std::size_t q, double length) const;
  double DistanceToSide(std::size_t p, const Index& at, int axis) const;
  float TrustAt(std::size_t p, const Index& at, int axis, double depth) const;
  Edge MakeEdge(std::size_t p, std::size_t q, int axis, const Index& at) const;
  void AddBeam(
    Edge& edge, std::size_t p, std::size_t q, int axis, const struct LayerMedium& medium) const;
  void MakeEdges();
  void MakeBoundaries();
  void MakeSides();
  void MakeMatrix();
  void Compare(const DiffuseField& ordinates, const DiffuseField& known);
  std::vector<double> RightSide() const;
  void WritePoint(
    std::size_t p, const Index& at, const DiffuseField* ordinates, DiffuseField& field) const;
  void SpreadDebt(std::vector<double>& power) const;
  void SettleGround(std::size_t p, DiffuseField& field) const;
  void CloseSeams(DiffuseField& field) const;

  const LightGrid& Grid;
  const Parallel& Rows;
  ColumnSolver Solver;
  std::vector<Edge> Edges[3];
  const BeamDeposit& Deposit;
  const double Height;
  std::vector<Boundary> Top, Ground, Sides[2]; // sides: of each row, its first and its last point
  std::vector<double> Fluence;
};

template <typename Body>
inline void LightBalance::ForPoints(Body body) const
{
  this->Rows(this->Grid.Width(1), [&](int j) {
    for (int k = 0; k < this->Grid.Size[2]; ++k)
    {
      const std::size_t row = j * this->Grid.Stride(1) + k * this->Grid.Stride(2);
      for (int i = 0; i < this->Grid.Width(0); ++i)
      {
        body(row + i, Index{ i, j, k });
      }
    }
  });
}
}

#endif
