// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file values.h
/// Values in a script's commands, in the ranges they must have. Each function throws
/// std::invalid_argument, "NAME is 'TEXT'; it must be ...", where the text is no such value.
#pragma once

#include <string>

namespace clay {

/// Any finite number.
double number(const std::string& name, const std::string& text);

/// A number greater than 0.
double positiveNumber(const std::string& name, const std::string& text);

/// A number greater than 0 and below 1.
double fraction(const std::string& name, const std::string& text);

/// A whole number of `least` or more.
long wholeNumber(const std::string& name, const std::string& text, long least);

/// A whole number from `least` to `most`.
long wholeNumber(const std::string& name, const std::string& text, long least, long most);

/// One of two words; true for the second.
bool choice(const std::string& name, const std::string& text, const std::string& first, const std::string& second);

/// yes or no.
inline bool yesOrNo(const std::string& name, const std::string& text) { return choice(name, text, "no", "yes"); }

}  // namespace clay
