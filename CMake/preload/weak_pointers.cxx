// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Preloaded into the tests, it makes them quicker: in VTK 9.2, adding or removing a weak pointer
 * takes a time proportional to the number of those that the object has.
 *
 * All properties and domains of ParaView point to their session. Each representation has thousands
 * of these, so that every source that is shown or deleted takes longer than the one before, and the
 * tests of the plugin spent up to a third of their time there. Here an object with many weak
 * pointers has an index of their places in its list. The list itself stays as VTK keeps it, for
 * vtkObjectBase, which clears it when the object is deleted; its order changes, which has no
 * meaning.
 */
#include "vtkWeakPointerBase.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <unordered_map>

namespace
{
constexpr std::size_t few = 64; // a list that is searched without an index

struct Index
{
  vtkWeakPointerBase** List = nullptr;
  std::size_t Count = 0;
  std::unordered_map<vtkWeakPointerBase*, std::size_t> Places;
};

std::mutex guard;

std::unordered_map<vtkObjectBase*, Index>& indices()
{
  static auto* all =
    new std::unordered_map<vtkObjectBase*, Index>; // weak pointers outlive static objects
  return *all;
}

std::size_t lengthUpTo(std::size_t limit, vtkWeakPointerBase* const* list)
{
  std::size_t length = 0;
  while (length < limit && list[length])
  {
    ++length;
  }
  return length;
}

// A list of this length has room for one more. VTK makes lists twice as long whenever their length
// is one less than a power of two.
vtkWeakPointerBase** withRoom(vtkWeakPointerBase** list, std::size_t length)
{
  if ((length & (length + 1)) != 0)
  {
    return list;
  }
  auto** longer = new vtkWeakPointerBase*[2 * (length + 1)];
  std::copy_n(list, length, longer);
  delete[] list;
  return longer;
}
}

VTK_ABI_NAMESPACE_BEGIN

// The class that vtkObjectBase lets see its list.
class vtkWeakPointerBaseToObjectBaseFriendship
{
public:
  static void Add(vtkObjectBase* object, vtkWeakPointerBase* pointer)
  {
    if (!object)
    {
      return;
    }
    vtkWeakPointerBase**& list = object->WeakPointers;
    if (!list)
    {
      list = new vtkWeakPointerBase* [2] { pointer, nullptr };
      return;
    }
    const std::size_t length = lengthUpTo(few, list);
    if (length < few)
    {
      list = withRoom(list, length);
      list[length] = pointer;
      list[length + 1] = nullptr;
      return;
    }
    const std::lock_guard<std::mutex> lock(guard);
    Index& index = indices()[object];
    if (!list[few])
    {
      index = NewIndex(list); // the old index may belong to a deleted object with the same address
    }
    index.List = list = withRoom(list, index.Count);
    index.Places[pointer] = index.Count;
    list[index.Count++] = pointer;
    list[index.Count] = nullptr;
  }

  static void Remove(vtkObjectBase* object, vtkWeakPointerBase* pointer)
  {
    if (!object || !object->WeakPointers)
    {
      return;
    }
    if (lengthUpTo(few + 1, object->WeakPointers) > few)
    {
      RemoveByIndex(object, pointer);
      return;
    }
    vtkWeakPointerBase**& list = object->WeakPointers;
    vtkWeakPointerBase** const end = list + lengthUpTo(few, list) + 1; // with the null pointer
    vtkWeakPointerBase** const found = std::find(list, end - 1, pointer);
    std::copy(std::min(found + 1, end), end, found);
    if (!list[0])
    {
      delete[] list;
      list = nullptr;
    }
  }

private:
  static Index NewIndex(vtkWeakPointerBase** list)
  {
    Index index;
    index.List = list;
    for (; list[index.Count]; ++index.Count)
    {
      index.Places[list[index.Count]] = index.Count;
    }
    return index;
  }

  // The last one takes the place of the one that is removed.
  static void RemoveByIndex(vtkObjectBase* object, vtkWeakPointerBase* pointer)
  {
    const std::lock_guard<std::mutex> lock(guard);
    Index& index = indices()[object];
    const auto found = index.Places.find(pointer);
    if (found == index.Places.end())
    {
      return;
    }
    vtkWeakPointerBase* const last = index.List[--index.Count];
    index.List[found->second] = last;
    index.Places[last] = found->second;
    index.List[index.Count] = nullptr;
    index.Places.erase(pointer);
    if (index.Count <= few)
    {
      indices().erase(object);
    }
  }
};

using Friendship = vtkWeakPointerBaseToObjectBaseFriendship;

vtkWeakPointerBase::vtkWeakPointerBase(vtkObjectBase* object)
  : Object(object)
{
  Friendship::Add(object, this);
}

vtkWeakPointerBase::vtkWeakPointerBase(vtkObjectBase* object, const NoReference&)
  : vtkWeakPointerBase(object)
{
}

vtkWeakPointerBase::vtkWeakPointerBase(const vtkWeakPointerBase& other)
  : vtkWeakPointerBase(other.Object)
{
}

vtkWeakPointerBase::vtkWeakPointerBase(vtkWeakPointerBase&& other) noexcept
  : vtkWeakPointerBase(other.Object)
{
  other = nullptr;
}

vtkWeakPointerBase::~vtkWeakPointerBase()
{
  Friendship::Remove(this->Object, this);
}

vtkWeakPointerBase& vtkWeakPointerBase::operator=(vtkObjectBase* object)
{
  if (this->Object != object)
  {
    Friendship::Remove(this->Object, this);
    this->Object = object;
    Friendship::Add(object, this);
  }
  return *this;
}

vtkWeakPointerBase& vtkWeakPointerBase::operator=(const vtkWeakPointerBase& other)
{
  return *this = other.Object;
}

vtkWeakPointerBase& vtkWeakPointerBase::operator=(vtkWeakPointerBase&& other) noexcept
{
  if (this != &other)
  {
    *this = other.Object;
    other = nullptr;
  }
  return *this;
}

VTK_ABI_NAMESPACE_END
