// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <string>

namespace epcc {

/// OutputError if the path has no folder, or is there and is anything but a file: a folder, a device, a pipe, or a
/// symbolic link, for a rename would replace it, and what it stands for may be somebody's input.
void checkOutputFile(const std::string& path);

/// Calls write(temporary_path) with a name in the same folder, then renames it to `path`, which checkOutputFile() has
/// passed. If `write` throws or the rename fails nothing is left behind; failures of the file system become
/// OutputError.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// Writes a text the same way.
void writeTextFile(const std::string& path, const std::string& text);

/// Removes what processes that were killed while writing have left in a folder and, with `below`, in those below it.
/// Nobody may be writing there.
void removeTemporaries(const std::string& folder, bool below);

}  // namespace epcc
