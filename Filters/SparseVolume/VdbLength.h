// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a .vdb file is as long as its grids say: OpenVDB itself takes what lies behind the end
// for values. Plain C++17.
#ifndef nephoscope_VdbLength_h
#define nephoscope_VdbLength_h

#include <cstdint>
#include <fstream>
#include <string>

namespace nephoscope
{
namespace vdb_length
{
template <typename Number>
Number Get(std::istream& in)
{
  Number number{};
  in.read(reinterpret_cast<char*>(&number), sizeof(number));
  return number;
}

// Text and metadata: their length in four bytes, then themselves.
inline void SkipSized(std::istream& in)
{
  in.seekg(Get<std::uint32_t>(in), std::ios::cur);
}
}

// The layout is that of file versions from 222 (2013) on, with offsets; other files are not looked
// at.
inline bool IsVdbTruncated(const std::string& file)
{
  using vdb_length::Get;
  using vdb_length::SkipSized;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::int64_t>(in.tellg());
  in.seekg(8); // behind the magic number
  const auto version = Get<std::uint32_t>(in);
  in.seekg(8, std::ios::cur); // version of the library
  const bool hasOffsets = Get<char>(in) != 0;
  if (in && (version < 222 || !hasOffsets))
  {
    return false;
  }
  in.seekg(36, std::ios::cur); // identification
  for (auto metadata = Get<std::uint32_t>(in); in && metadata > 0; --metadata)
  {
    SkipSized(in); // name
    SkipSized(in); // type
    SkipSized(in); // value
  }
  for (auto grids = Get<std::int32_t>(in); in && grids > 0; --grids)
  {
    SkipSized(in);               // name
    SkipSized(in);               // type
    SkipSized(in);               // the grid that it shares its voxels with
    in.seekg(16, std::ios::cur); // its place and that of its values
    const auto end = Get<std::int64_t>(in);
    if (!in || end > size)
    {
      return true;
    }
    in.seekg(end);
  }
  return !in;
}
}

#endif
