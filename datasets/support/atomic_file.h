// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <string>

namespace epcc {

/// Calls write(temporary_path) with a name in the same folder, then renames it to `path`. If `write` throws or
/// the rename fails nothing is left behind; failures of the file system become OutputError.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// Writes a text the same way.
void writeTextFile(const std::string& path, const std::string& text);

/// Removes what processes that were killed while writing have left in a folder and, with `below`, in those below it.
/// Nobody may be writing there.
void removeTemporaries(const std::string& folder, bool below);

}  // namespace epcc
