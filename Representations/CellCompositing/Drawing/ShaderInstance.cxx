// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderInstance.h"

#include <algorithm>
#include <cctype>
#include <mutex>
#include <set>
#include <vector>

namespace nephoscope
{
namespace
{
bool IsNamePart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/**
 * Names, numbers and single characters, one after the other; a line of the preprocessor begins with
 * '#'. Comments and blanks are tokens too.
 */
std::vector<std::string> TokensOf(const std::string& text)
{
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < text.size();)
  {
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0)
    {
      end = std::min(text.find('\n', i), text.size());
    }
    else if (IsNamePart(text[i]))
    {
      while (end < text.size() &&
        (IsNamePart(text[end]) ||
          (text[end] == '.' && std::isdigit(static_cast<unsigned char>(text[i])))))
      {
        ++end;
      }
    }
    tokens.push_back(text.substr(i, end - i));
    i = end;
  }
  return tokens;
}

bool IsName(const std::string& token)
{
  return IsNamePart(token[0]) && !std::isdigit(static_cast<unsigned char>(token[0]));
}

bool IsBlank(const std::string& token)
{
  return std::isspace(static_cast<unsigned char>(token[0])) || token.compare(0, 2, "//") == 0;
}

/**
 * What matters of the tokens to tell what is declared: all but blanks and what a preprocessor's
 * line holds behind a macro's name.
 */
class Declarations
{
public:
  explicit Declarations(const std::vector<std::string>& tokens)
  {
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
      if (tokens[i] == "#")
      {
        i = this->ReadDirective(tokens, i + 1);
      }
      else if (!IsBlank(tokens[i]))
      {
        this->Read(tokens[i]);
      }
    }
  }

  std::set<std::string> Names;

private:
  std::size_t ReadDirective(const std::vector<std::string>& tokens, std::size_t i)
  {
    const bool defines = tokens[i] == "define";
    for (bool named = false; i < tokens.size() && tokens[i] != "\n"; ++i)
    {
      if (defines && !named && IsName(tokens[i]) && tokens[i] != "define")
      {
        this->Names.insert(tokens[i]);
        named = true;
      }
    }
    return i;
  }

  // A name outside of all brackets is declared where a type or a comma is before it, and one of = ;
  // , [ ( behind.
  void Read(const std::string& token)
  {
    const bool ends =
      token == "=" || token == ";" || token == "," || token == "[" || token == "(" || token == "{";
    if (this->Depth == 0 && ends && IsName(this->Last) &&
      (this->BeforeLast == "struct" || this->BeforeLast == "," || IsName(this->BeforeLast)) &&
      (token != "{" || this->BeforeLast == "struct"))
    {
      this->Names.insert(this->Last);
    }
    this->Depth += token == "{" || token == "(" || token == "[" ? 1 : 0;
    this->Depth -= token == "}" || token == ")" || token == "]" ? 1 : 0;
    this->BeforeLast = this->Last;
    this->Last = token;
  }

  int Depth = 0;
  std::string Last = ";", BeforeLast = ";";
};
}

const char* InstanceName(const char* name, int number)
{
  if (number < 0)
  {
    return name;
  }
  static std::mutex mutex;
  static std::set<std::string> names;
  const std::lock_guard<std::mutex> lock(mutex);
  return names.insert(name + ("_" + std::to_string(number))).first->c_str();
}

std::string ShaderInstance(const std::string& text, int number)
{
  const std::vector<std::string> tokens = TokensOf(text);
  const Declarations declared(tokens);
  std::string result;
  for (const std::string& token : tokens)
  {
    const bool renamed = IsName(token) && declared.Names.count(token) > 0;
    result += token.compare(0, 2, "//") == 0 ? std::string() : token;
    result += renamed ? "_" + std::to_string(number) : std::string();
  }
  return result;
}

std::string CallInstances(const std::string& function, const std::string& of,
  const std::string& parameters, const std::string& arguments, int count)
{
  std::string result = "void " + function + "(" + parameters + ")\n{\n";
  for (int i = 0; i < count; ++i)
  {
    result += "  " + of + "_" + std::to_string(i) + "(" + arguments + ");\n";
  }
  return result + "}\n";
}

} // namespace nephoscope
