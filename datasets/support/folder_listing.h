// SPDX-License-Identifier: BSD-3-Clause
// Names of the files of a folder by their ending, numbers in numeric order.
#pragma once

#include <string>
#include <vector>

namespace epcc {

/// True if `file` is a name and then `ending`, such as "_depth.png", whose extension may also be in capitals.
bool hasEnding(const std::string& file, const std::string& ending);
/// True if numbers within the names put `a` before `b`: "2" before "10".
bool naturallyBefore(const std::string& a, const std::string& b);

/// Last part of the path, also of "frames/", "." and ".."; "root" for "/".
std::string folderName(const std::string& folder);

/// Names of the files in `folder` that have the ending, without it, in natural order. InputError if the folder cannot
/// be listed.
std::vector<std::string> filesEndingIn(const std::string& folder, const std::string& ending);
/// Path of the first file met that has the ending; empty if there is none or the folder cannot be listed.
std::string anyFileEndingIn(const std::string& folder, const std::string& ending);
/// The path itself, or with its extension in capitals if that is the file that exists.
std::string existingFile(const std::string& path);

}  // namespace epcc
