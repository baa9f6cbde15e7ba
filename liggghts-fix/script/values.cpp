// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "script/values.h"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace clay {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& text, const std::string& wanted)
{
  throw std::invalid_argument(name + " is '" + text + "'; it must be " + wanted);
}

bool isNumber(const std::string& text, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && !*end && std::isfinite(value);
}

bool isWhole(const std::string& text, long& value)
{
  char* end = nullptr;
  errno = 0;
  value = std::strtol(text.c_str(), &end, 10);
  return !text.empty() && !*end && errno == 0;
}

}  // namespace

double number(const std::string& name, const std::string& text)
{
  double value;
  if (!isNumber(text, value)) refuse(name, text, "a number");
  return value;
}

double positiveNumber(const std::string& name, const std::string& text)
{
  double value;
  if (!isNumber(text, value) || !(value > 0)) refuse(name, text, "a number greater than 0");
  return value;
}

double fraction(const std::string& name, const std::string& text)
{
  double value;
  if (!isNumber(text, value) || !(value > 0 && value < 1)) refuse(name, text, "a number greater than 0 and below 1");
  return value;
}

long wholeNumber(const std::string& name, const std::string& text, long least)
{
  long value;
  if (!isWhole(text, value) || value < least)
    refuse(name, text, "a whole number of " + std::to_string(least) + " or more");
  return value;
}

long wholeNumber(const std::string& name, const std::string& text, long least, long most)
{
  long value;
  if (!isWhole(text, value) || value < least || value > most)
    refuse(name, text, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value;
}

bool choice(const std::string& name, const std::string& text, const std::string& first, const std::string& second)
{
  if (text != first && text != second) refuse(name, text, second + " or " + first);
  return text == second;
}

}  // namespace clay
