// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelWords.h"

#include "vtkPVProxyDefinitionIterator.h"
#include "vtkPVSessionBase.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSIProxyDefinitionManager.h"
#include "vtkSmartPointer.h"

#include <cctype>
#include <map>

namespace nephoscope
{
namespace
{
using Words = std::map<std::string, std::string>;

// What only programs can do, and what does the same in ParaView.
const Words remedies = {
  { "Color Map Editor", "Color Map Editor" }, // not of a property Color
  { "Solid Color", "Solid Color" },
  { "Choose an array with SelectScalarArray and SetScalarMode", "Choose an array by Coloring" },
  { "ScalarOpacityUnitDistance of the property", "Scalar Opacity Unit Distance" },
  { "ScalarOpacityUnitDistance", "Scalar Opacity Unit Distance" },
  { "add some with AddPoint", "add some in the Color Map Editor" },
  { "add some with AddRGBPoint", "add some in the Color Map Editor" },
  { "call SetVectorColorFunction", "set Vector Color Map" },
  { "set MaximumSpeed", "set Greatest Speed" },
  { "call SetMethodToCells()", "set Method to Cells" },
  { "call SetPolygonsToAll()", "set Polygons to All" },
  { "Call SetVectorPlacementToMiddle()", "Set Vector Placement to Middle" },
  { "call UseDepthPeelingForVolumesOff() of the renderer", "hide the translucent surfaces" },
  { "Call SetNumberOfContourValues or SetContourValue first", "Add Contour Values first" },
  { "Set CellInterpolation to Trilinear", "Set Cell Interpolation to Trilinear" },
  { "run vtkPolyhedronToTetrahedra first", "apply Polyhedron To Tetrahedra first" },
  { "vtkMeshQuality finds", "Mesh Quality finds" },
  { "call SetOrigin and SetNormal of the vtkPlane", "set Origin and Normal" },
  { "vtkHyperTreeGridToUnstructuredGrid", "HyperTreeGrid To UnstructuredGrid" },
  { "vtkResampleToImage", "Resample To Image" },
  { "use vtkTriangleFilter", "apply Triangulate" },
  { "use one of the values of MethodType", "choose one of the values of Method" },
  { "SetFileName gives the .vdb file", "File Name is the .vdb file" },
};

// Units stand at the end of labels.
std::string WithoutUnit(const std::string& label)
{
  const auto at = label.rfind(" (");
  return at != std::string::npos && label.back() == ')' ? label.substr(0, at) : label;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void Add(Words& words, vtkPVXMLElement* property)
{
  const std::string label = property->GetAttributeOrEmpty("label");
  const std::string name = property->GetAttributeOrEmpty("command");
  if (label.empty() || name.size() < 4 ||
    !(name.compare(0, 3, "Set") == 0 || name.compare(0, 3, "Add") == 0))
  {
    return;
  }
  const std::string shown = WithoutUnit(label);
  words.emplace(name, shown);
  words.emplace(name.substr(3), shown);
  if (EndsWith(name, "Array")) // of representations; their mappers say it so
  {
    words.emplace(name + "Name", shown);
    words.emplace(name.substr(3) + "Name", shown);
  }
}

void AddAll(Words& words, vtkPVXMLElement* definition)
{
  for (unsigned int i = 0; i < definition->GetNumberOfNestedElements(); ++i)
  {
    Add(words, definition->GetNestedElement(i));
  }
}

Words WordsOf(const std::string& className)
{
  Words words = remedies;
  auto* session =
    vtkPVSessionBase::SafeDownCast(vtkProcessModule::GetProcessModule()->GetSession());
  vtkSIProxyDefinitionManager* manager = session ? session->GetProxyDefinitionManager() : nullptr;
  if (!manager)
  {
    return words;
  }
  vtkSmartPointer<vtkPVProxyDefinitionIterator> proxies;
  proxies.TakeReference(manager->NewIterator());
  for (proxies->InitTraversal(); !proxies->IsDoneWithTraversal(); proxies->GoToNextItem())
  {
    vtkPVXMLElement* definition = proxies->GetProxyDefinition();
    if (definition && className + "WithLabels" == definition->GetAttributeOrEmpty("class"))
    {
      AddAll(words, definition);
    }
  }
  return words;
}

bool IsPartOfWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Whether what begins there ends with a word; names of files and classes in the head of a message
// begin with a capital too.
bool IsWhole(const std::string& text, std::size_t begin, std::size_t end)
{
  return (begin == 0 || !IsPartOfWord(text[begin - 1])) &&
    (end == text.size() || !IsPartOfWord(text[end]));
}
}

std::string InWordsOfPanel(const std::string& text, const std::string& className)
{
  const Words words = WordsOf(className);
  std::string result;
  for (std::size_t at = 0; at < text.size();)
  {
    const Words::value_type* longest = nullptr;
    for (const auto& word : words)
    {
      const std::size_t length = word.first.size();
      if (text.compare(at, length, word.first) == 0 && IsWhole(text, at, at + length) &&
        (!longest || longest->first.size() < length))
      {
        longest = &word;
      }
    }
    result += longest ? longest->second : std::string(1, text[at]);
    at += longest ? longest->first.size() : 1;
  }
  return result;
}

} // namespace nephoscope
