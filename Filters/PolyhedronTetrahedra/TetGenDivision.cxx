// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenDivision.h"

#ifndef NEPHOSCOPE_HAS_TETGEN

namespace nephoscope
{
bool IsBuiltWithTetGen()
{
  return false;
}

void DivideTasksByTetGen(std::vector<TetGenTask>& tasks, const std::function<bool()>&)
{
  for (TetGenTask& task : tasks)
  {
    task.Failure = "this build has no TetGen";
  }
}
} // namespace nephoscope

#else

#include "IsolatedProcess.h"

#include <tetgen.h> // compiled with TETLIBRARY: errors are thrown as int

#include <cstring>
#include <new>

namespace nephoscope
{
namespace
{
constexpr double longestSeconds = 20; // for one cell; a cell of 100 faces takes a few thousandths

/**
 * The cell moved to the origin and to a size of about 1 by a power of two, which rounds nothing.
 */
struct Frame
{
  explicit Frame(const PolyhedronSurface& surface)
    : Origin(surface.Position(surface.NumberOfVertices() / 2))
    , Scale(std::exp2(-std::ceil(std::log2(surface.Size()))))
  {
  }
  Vector3 Inward(const Vector3& x) const
  {
    const Vector3 d = Difference(x, this->Origin);
    return { { d[0] * this->Scale, d[1] * this->Scale, d[2] * this->Scale } };
  }
  Vector3 Outward(const Vector3& x) const
  {
    return { { x[0] / this->Scale + this->Origin[0], x[1] / this->Scale + this->Origin[1],
      x[2] / this->Scale + this->Origin[2] } };
  }
  Vector3 Origin;
  double Scale;
};

// Where the line from p along d crosses a triangle: the multiple of d, or a negative number.
double FindCrossing(
  const Vector3& p, const Vector3& d, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = Difference(b, a), ac = Difference(c, a), ap = Difference(p, a);
  const Vector3 h = Cross(d, ac);
  const double determinant = Dot(ab, h);
  if (determinant == 0)
  {
    return -1;
  }
  const double u = Dot(ap, h) / determinant;
  const Vector3 q = Cross(ap, ab);
  const double v = Dot(d, q) / determinant;
  return u < 0 || v < 0 || u + v > 1 ? -1 : Dot(ac, q) / determinant;
}

// A point inside the cavity behind a face: halfway from a triangle's middle to what lies opposite.
Vector3 PointInCavity(const TriangulatedSurface& cut, const Frame& frame, int face)
{
  const auto first = std::find(cut.FaceOf.begin(), cut.FaceOf.end(), face) - cut.FaceOf.begin();
  auto corners = [&](std::size_t triangle) {
    const Triangle& t = cut.Triangles[triangle];
    return std::array<Vector3, 3>{ { frame.Inward(cut.Surface->Position(t[0])),
      frame.Inward(cut.Surface->Position(t[1])), frame.Inward(cut.Surface->Position(t[2])) } };
  };
  const auto [a, b, c] = corners(static_cast<std::size_t>(first));
  const Vector3 normal = Cross(Difference(b, a), Difference(c, a));
  Vector3 middle;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = (a[axis] + b[axis] + c[axis]) / 3;
  }
  double nearest = 1e300;
  for (std::size_t i = 0; i < cut.Triangles.size(); ++i)
  {
    const auto [p, q, r] = corners(i);
    const double t =
      i == static_cast<std::size_t>(first) ? -1 : FindCrossing(middle, normal, p, q, r);
    nearest = t > 0 ? std::min(nearest, t) : nearest;
  }
  const double half = nearest / 2;
  return { { middle[0] + half * normal[0], middle[1] + half * normal[1],
    middle[2] + half * normal[2] } };
}

void SetPoint(double* list, int index, const Vector3& x)
{
  std::copy(x.begin(), x.end(), list + 3 * index);
}

void FillInput(const TriangulatedSurface& cut, const Frame& frame, tetgenio& in)
{
  in.firstnumber = 0;
  in.numberofpoints = cut.Surface->NumberOfVertices();
  in.pointlist = new double[3 * static_cast<std::size_t>(in.numberofpoints)];
  for (int v = 0; v < in.numberofpoints; ++v)
  {
    SetPoint(in.pointlist, v, frame.Inward(cut.Surface->Position(v)));
  }
  in.numberoffacets = static_cast<int>(cut.Triangles.size());
  in.facetlist = new tetgenio::facet[cut.Triangles.size()];
  in.facetmarkerlist = new int[cut.Triangles.size()];
  for (std::size_t i = 0; i < cut.Triangles.size(); ++i)
  {
    in.facetmarkerlist[i] = static_cast<int>(i) + 1;
    tetgenio::facet& facet = in.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.polygonlist[0].numberofvertices = 3;
    facet.polygonlist[0].vertexlist = new int[3];
    std::copy(cut.Triangles[i].begin(), cut.Triangles[i].end(), facet.polygonlist[0].vertexlist);
  }
  const std::vector<int>& cavities = cut.Surface->CavityFaces();
  in.numberofholes = static_cast<int>(cavities.size());
  in.holelist = cavities.empty() ? nullptr : new double[3 * cavities.size()];
  for (int h = 0; h < in.numberofholes; ++h)
  {
    SetPoint(in.holelist, h, PointInCavity(cut, frame, cavities[static_cast<std::size_t>(h)]));
  }
}

/**
 * What the child sends: TetGen's code, the numbers of new points and tetrahedra, these themselves.
 */
struct Header
{
  int Code;
  int NewPoints;
  int Tetrahedra;
};

template <typename T>
void Append(std::vector<char>& bytes, const T* values, std::size_t count)
{
  const char* begin = reinterpret_cast<const char*>(values);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

std::vector<char> Pack(const tetgenio& out, int numberOfVertices, int code)
{
  std::vector<char> bytes;
  const Header header = { code, code ? 0 : out.numberofpoints - numberOfVertices,
    code ? 0 : out.numberoftetrahedra };
  Append(bytes, &header, 1);
  if (code == 0)
  {
    Append(
      bytes, out.pointlist + 3 * numberOfVertices, 3 * static_cast<std::size_t>(header.NewPoints));
    Append(bytes, out.tetrahedronlist, 4 * static_cast<std::size_t>(header.Tetrahedra));
  }
  return bytes;
}

// Returns TetGen's code.
int Unpack(const std::vector<char>& bytes, const Frame& frame, CellDivision& division)
{
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  const char* next = bytes.data() + sizeof header;
  for (int v = 0; v < header.NewPoints; ++v, next += 3 * sizeof(double))
  {
    Vector3 x;
    std::memcpy(x.data(), next, sizeof x);
    division.NewPoints.push_back(frame.Outward(x));
  }
  for (int t = 0; t < header.Tetrahedra; ++t, next += 4 * sizeof(int))
  {
    std::array<int, 4> corners;
    std::memcpy(corners.data(), next, sizeof corners);
    division.Tetrahedra.push_back(corners);
  }
  return header.Code;
}

// 0, or the code that TetGen throws: tetgen.h, terminatetetgen.
int CallTetGen(tetgenio& in, tetgenio& out)
{
  // p: a surface. Y: leave the surface unchanged. M: do not merge triangles of one plane. Q: quiet.
  char switches[] = "pYMQ";
  try
  {
    tetrahedralize(switches, &in, &out);
    return 0;
  }
  catch (int code)
  {
    return code;
  }
  catch (const std::bad_alloc&)
  {
    return 1;
  }
}

std::string Explain(int code)
{
  switch (code)
  {
    case 0:
      return std::string();
    case 1:
      return "it ran out of memory";
    case 3:
      return "the surface crosses itself";
    case 4:
    case 5:
      return "faces lie too close together";
    default:
      return "it gave up with code " + std::to_string(code);
  }
}

std::vector<char> Divide(const TriangulatedSurface& surface)
{
  // Never freed: after an error TetGen may have freed parts of them, and the child ends soon.
  auto* in = new tetgenio;
  auto* out = new tetgenio;
  FillInput(surface, Frame(*surface.Surface), *in);
  const int code = CallTetGen(*in, *out);
  return Pack(*out, surface.Surface->NumberOfVertices(), code);
}
}

bool IsBuiltWithTetGen()
{
  return true;
}

void DivideTasksByTetGen(std::vector<TetGenTask>& tasks, const std::function<bool()>& keepGoing)
{
  const std::vector<IsolatedResult> results = RunIsolated(
    static_cast<int>(tasks.size()), longestSeconds,
    [&](int i) { return Divide(*tasks[static_cast<std::size_t>(i)].Surface); }, keepGoing);
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    tasks[i].Failure = results[i].Failure;
    if (tasks[i].Failure.empty())
    {
      tasks[i].Failure =
        Explain(Unpack(results[i].Bytes, Frame(*tasks[i].Surface->Surface), *tasks[i].Division));
    }
  }
}

} // namespace nephoscope

#endif
