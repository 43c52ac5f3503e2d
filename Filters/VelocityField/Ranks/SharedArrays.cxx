// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedArrays.h"

#include "ArrayInterpolation.h"
#include "VelocityFields.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>

namespace nephoscope
{
SharedArrays::SharedArrays(const DataSetField* local, vtkMultiProcessController* controller)
{
  const int ranks = controller->GetNumberOfProcesses();
  const int candidate = local ? controller->GetLocalProcessId() : ranks;
  controller->AllReduce(&candidate, &this->First, 1, vtkCommunicator::MIN_OP);
  const std::vector<Entry> own = local ? Describe(*local) : std::vector<Entry>();
  this->Add(Broadcast(own, controller, this->First));
  const int differs = local && !AreSame(own, this->Entries) ? 1 : 0;
  int anyDiffers = 0;
  controller->AllReduce(&differs, &anyDiffers, 1, vtkCommunicator::MAX_OP);
  for (int rank = 0; rank < ranks && anyDiffers; ++rank) // blocks with different arrays
  {
    this->Add(Broadcast(own, controller, rank));
  }
}

// Those whose names are new.
void SharedArrays::Add(const std::vector<Entry>& entries)
{
  for (const Entry& entry : entries)
  {
    if (!Find(this->Entries, entry.Name))
    {
      this->Entries.push_back(entry);
      this->Size += entry.Size;
    }
  }
}

std::vector<SharedArrays::Entry> SharedArrays::Describe(const DataSetField& field)
{
  vtkNew<vtkPointData> data;
  field.SampleArrays(0, nullptr, nullptr, data);
  std::vector<Entry> entries;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || !array->GetName() || array->GetDataType() == VTK_BIT) // bits are not bytes
    {
      continue;
    }
    Entry entry;
    entry.Name = array->GetName();
    entry.Type = array->GetDataType();
    entry.Components = array->GetNumberOfComponents();
    entry.Attribute = data->IsArrayAnAttribute(i);
    entry.Size = static_cast<std::size_t>(array->GetDataTypeSize()) *
      static_cast<std::size_t>(entry.Components);
    for (int c = 0; c < entry.Components && array->HasAComponentName(); ++c)
    {
      const char* name = array->GetComponentName(c);
      entry.ComponentNames.emplace_back(name ? name : "");
    }
    entries.push_back(entry);
  }
  return entries;
}

const SharedArrays::Entry* SharedArrays::Find(
  const std::vector<Entry>& entries, const std::string& name)
{
  const auto found = std::find_if(
    entries.begin(), entries.end(), [&](const Entry& entry) { return entry.Name == name; });
  return found == entries.end() ? nullptr : &*found;
}

bool SharedArrays::AreSame(const std::vector<Entry>& a, const std::vector<Entry>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Entry& x, const Entry& y) {
    return x.Name == y.Name && x.Type == y.Type && x.Components == y.Components;
  });
}

std::vector<SharedArrays::Entry> SharedArrays::Broadcast(
  const std::vector<Entry>& own, vtkMultiProcessController* controller, int root)
{
  vtkMultiProcessStream stream;
  const bool sends = controller->GetLocalProcessId() == root;
  if (sends)
  {
    stream << static_cast<int>(own.size());
    for (const Entry& entry : own)
    {
      stream << entry.Name << entry.Type << entry.Components << entry.Attribute
             << static_cast<int>(entry.Size) << static_cast<int>(entry.ComponentNames.size());
      for (const std::string& name : entry.ComponentNames)
      {
        stream << name;
      }
    }
  }
  controller->Broadcast(stream, root);
  if (sends)
  {
    return own;
  }
  int count = 0;
  stream >> count;
  std::vector<Entry> entries(static_cast<std::size_t>(count));
  for (Entry& entry : entries)
  {
    int size = 0;
    int names = 0;
    stream >> entry.Name >> entry.Type >> entry.Components >> entry.Attribute >> size >> names;
    entry.Size = static_cast<std::size_t>(size);
    entry.ComponentNames.resize(static_cast<std::size_t>(names));
    for (std::string& name : entry.ComponentNames)
    {
      stream >> name;
    }
  }
  return entries;
}

void SharedArrays::Allocate(std::size_t count, vtkPointData* output) const
{
  for (const Entry& entry : this->Entries)
  {
    const auto array =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(entry.Type));
    array->SetName(entry.Name.c_str());
    array->SetNumberOfComponents(entry.Components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
    for (std::size_t c = 0; c < entry.ComponentNames.size(); ++c)
    {
      array->SetComponentName(static_cast<vtkIdType>(c), entry.ComponentNames[c].c_str());
    }
    output->AddArray(array);
    if (entry.Attribute >= 0)
    {
      output->SetActiveAttribute(entry.Name.c_str(), entry.Attribute);
    }
  }
}

void SharedArrays::Pack(
  vtkPointData* sampled, const std::vector<std::size_t>& places, unsigned char* bytes) const
{
  std::size_t offset = 0;
  for (const Entry& entry : this->Entries)
  {
    vtkDataArray* source = sampled->GetArray(entry.Name.c_str());
    const auto plain =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(entry.Type));
    if (source && source->GetNumberOfComponents() == entry.Components)
    {
      plain->DeepCopy(source); // of this type, in the plain layout
    }
    else
    {
      plain->SetNumberOfComponents(entry.Components);
      plain->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
      for (vtkIdType i = 0; i < plain->GetNumberOfTuples(); ++i)
      {
        SetOutside(plain, i);
      }
    }
    const auto* values = static_cast<const unsigned char*>(plain->GetVoidPointer(0));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::memcpy(bytes + places[i] * this->Size + offset, values + i * entry.Size, entry.Size);
    }
    offset += entry.Size;
  }
}

void SharedArrays::Unpack(
  const unsigned char* bytes, std::size_t count, std::size_t first, vtkPointData* output) const
{
  std::size_t offset = 0;
  for (const Entry& entry : this->Entries)
  {
    auto* values =
      static_cast<unsigned char*>(output->GetArray(entry.Name.c_str())->GetVoidPointer(0));
    for (std::size_t i = 0; i < count; ++i)
    {
      std::memcpy(values + (first + i) * entry.Size, bytes + i * this->Size + offset, entry.Size);
    }
    offset += entry.Size;
  }
}
}
