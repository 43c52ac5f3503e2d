// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws correctly the tetrahedra that hide one another in a cycle, which no order of whole tetrahedra does.
 *
 * A cycle has a relation "A is behind B", and so a face of B whose plane has B on the eye's side. All tetrahedra of the cycle are
 * cut by that plane; first comes what lies beyond it, then what lies before it, each in an order of its own. On neither side does
 * the relation remain: beyond the plane there is no B, and a ray that has left B through this face is beyond the plane. Whatever
 * cycles are left are cut in turn (the idea of binary space partitioning, FuchsKedemNaylor1980, used only where it must be).
 */
#ifndef CycleSplitter_h
#define CycleSplitter_h

#include "CellPieces.h"
#include "ProgressLoop.h"
#include "TetrahedronCut.h"

#include <chrono>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class CycleSplitter
{
public:
  /** Tetrahedron Behind is seen through the face of Front that is opposite its vertex Opposite; numbers of members. */
  struct Relation
  {
    std::int32_t Behind, Front, Opposite;
  };

  /** Pieces beyond `maximumPieces` are not made; the remaining tetrahedra are drawn whole, in the wrong order. */
  CycleSplitter(const CellGeometry& geometry, const Vector4& eye, double coordinateError,
    std::size_t maximumPieces);

  /**
   * Appends the members of a cycle to `order`, from back to front, cut ones by the numbers of their pieces (CellPieces.h).
   * `relations` number the members from 0. False when stopped.
   */
  bool Append(const std::vector<std::int32_t>& members, const std::vector<Relation>& relations,
    CellPieces& pieces, std::vector<std::int32_t>& order, const Progress& progress = {});

  /** Relations that the order breaks nevertheless. */
  std::int64_t GetNumberOfBrokenRelations() const { return this->Broken; }

private:
  using Clock = std::chrono::steady_clock;
  struct HalfSpace
  {
    Plane Border;
    bool Far; // or near
  };
  /**
   * What is left of a member in a part of space: nothing is cut off as long as Tetrahedra is empty, else them, back to front.
   * They are made by cutting the whole by Borders, the last one first: many an earlier one then cuts nothing any more and is
   * forgotten. (Cutting what earlier cuts left would multiply the pieces at every cut.)
   */
  struct Part
  {
    std::int32_t Member;
    std::vector<HalfSpace> Borders;
    std::vector<CutTetrahedron> Tetrahedra;
  };
  struct Group
  {
    std::vector<Part> Parts;
    std::vector<Relation> Relations;
  };

  bool Order(Group group);
  bool Report();
  std::vector<Group> FindGroups(Group& group);
  Plane FindPlane(const Relation& relation) const;
  Plane ChoosePlane(const Group& group) const;
  std::int64_t CostOf(const Plane& plane, const Group& group) const;
  void Split(Group& group, const Plane& plane, Group& far, Group& near);
  void SplitPart(Part& part, const Plane& plane, Group& far, Group& near) const;
  void AddRest(
    const Part& part, const std::array<Vector3, 4>& p, const HalfSpace& border, Group& half) const;
  bool Clip(
    std::vector<CutTetrahedron>& tetrahedra, const HalfSpace& border, double tolerance) const;
  void KeepRelations(const Group& group, const Plane& plane, double side, Group& half);
  void EmitBroken(const Group& group);
  void Emit(const Part& part);
  std::array<Vector3, 4> VerticesOf(std::int32_t member) const;
  double ToleranceOf(const std::array<Vector3, 4>& p) const;

  const CellGeometry& Geometry;
  const Vector4 Eye;
  const double CoordinateError;
  const std::size_t MaximumPieces;
  std::int64_t Broken = 0;

  // of the call in progress
  const std::vector<std::int32_t>* Members = nullptr;
  CellPieces* Pieces = nullptr;
  std::vector<std::int32_t>* Result = nullptr;
  std::vector<std::int32_t> NodeOf; // per member: its place among the parts, or -1
  std::vector<std::uint32_t> Mark;  // per member: the last half that it was found in
  std::uint32_t NumberOfHalves = 0;
  const Progress* Listener = nullptr;
  Clock::time_point LastReport;
  std::size_t Finished = 0; // parts
};

} // namespace nephoscope

#endif
