// SPDX-License-Identifier: BSD-3-Clause
// Pieces of a web page that needs nothing but itself: no link, no font, no script from elsewhere.
#pragma once

#include <string>

#include "eval/report/table.h"

namespace epcc {

/// Everything before the first section, with styles; `title` is plain text.
std::string htmlHead(const std::string& title);
/// Everything after the last section, with the script that sorts and filters the tables.
std::string htmlTail();

std::string escapeHtml(const std::string& text);

/// A table whose headings sort it; cells of the column "median_ms" carry the class "time".
std::string htmlTable(const Table& table);

/// An image within the page; empty if there is no such file.
std::string htmlPicture(const std::string& png_path, const std::string& alternative_text);

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace epcc
