// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace epcc {

/// The file that is written when `path` is: itself or, if it is a symbolic link, what it stands for. OutputError if
/// that is a folder, a device or a stream, or has no folder.
std::filesystem::path writtenFile(const std::string& path);

/// Calls write(temporary_path) with a name in the folder of the file, then renames it to writtenFile(path). If `write`
/// throws or the rename fails nothing is left behind; failures of the file system become OutputError.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// Writes a text the same way.
void writeTextFile(const std::string& path, const std::string& text);

/// Removes what processes that were killed while writing have left in a folder and, with `below`, in those below it.
/// Nobody may be writing there.
void removeTemporaries(const std::string& folder, bool below);

}  // namespace epcc
