// SPDX-License-Identifier: BSD-3-Clause
// Names of the files of a folder by their ending, numbers in numeric order.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace epcc {

/// True if `text` ends in `ending`.
bool endsIn(const std::string& text, const std::string& ending);
/// True if numbers within the names put `a` before `b`: "2" before "10".
bool naturallyBefore(const std::string& a, const std::string& b);

/// Last part of the path, also of "frames/", "." and ".."; "root" for "/".
std::string folderName(const std::string& folder);

using NameTest = std::function<bool(const std::string& file)>;

/// Names of the files in `folder` that pass, in natural order. InputError if the folder cannot be listed.
std::vector<std::string> filesThat(const std::string& folder, const NameTest& pass);
/// The names of those that end in `ending`, without it.
std::vector<std::string> filesEndingIn(const std::string& folder, const std::string& ending);
/// The first file met that passes, whole path; empty if there is none or the folder cannot be listed.
std::string anyFileThat(const std::string& folder, const NameTest& pass);
std::string anyFileEndingIn(const std::string& folder, const std::string& ending);

}  // namespace epcc
