// SPDX-License-Identifier: BSD-3-Clause
// The page is one file: style, script and pictures are inside it.
#include "eval/report/html_page.h"

#include <cstdint>
#include <fstream>
#include <sstream>

namespace epcc {

namespace {

// The policy makes the browser refuse whatever is not in the page itself.
constexpr const char* kHead = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<style>
:root { color-scheme: light dark; --line: #8886; --soft: #8882; --mark: #2a6db0; }
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 1500px; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.2em; margin-top: 2em; } h3 { font-size: 1em; margin: 1.5em 0 .3em; }
.scroll { overflow: auto; max-height: 80vh; border: 1px solid var(--line); }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25em .7em; border-bottom: 1px solid var(--line); white-space: nowrap; text-align: left; }
th { position: sticky; top: 0; background: Canvas; cursor: pointer; }
th:hover, th:focus { color: var(--mark); }
th[aria-sort=ascending]::after { content: " \25B2"; } th[aria-sort=descending]::after { content: " \25BC"; }
.r { text-align: right; } tbody tr:hover { background: var(--soft); }
.frames { display: flex; flex-wrap: wrap; gap: .6em; } figure { margin: 0; width: 200px; }
figure img { width: 100%; display: block; } figcaption { font-size: .85em; } .none { height: 4em; background: var(--soft); }
input { font: inherit; margin: .4em 0; padding: .2em .5em; width: 22em; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1em 1em; } dt { font-weight: 600; } dd { margin: 0; }
</style>
)";

// Numbers are compared as numbers, "-" and empty cells always come last, equal rows keep their order.
constexpr const char* kScript = R"(<script>
function value(row, column) {
  const text = row.cells[column].textContent.trim();
  return text === "" || text === "-" ? null : isNaN(text) ? text : Number(text);
}
function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}
function sortBy(heading) {
  const table = heading.closest("table"), body = table.tBodies[0], column = heading.cellIndex;
  const sign = heading.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  for (const other of heading.parentNode.cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
  const rows = Array.from(body.rows, row => [value(row, column), row]);
  rows.sort(([a], [b]) => a === null || b === null ? (a === null) - (b === null) : sign * compare(a, b));
  body.append(...rows.map(([, row]) => row));
}
for (const heading of document.querySelectorAll("th")) {
  heading.tabIndex = 0;
  heading.addEventListener("click", () => sortBy(heading));
  heading.addEventListener("keydown", event => { if (event.key === "Enter") sortBy(heading); });
}
for (const input of document.querySelectorAll("input")) {
  const rows = input.parentNode.querySelectorAll("tbody tr");
  input.addEventListener("input", () => {
    const words = input.value.toLowerCase().split(/\s+/);
    for (const row of rows) row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
  });
}
</script>
)";

const char* cellClass(const TableColumn& column) {
  if (column.title == "median_ms") return " class=\"r time\"";
  return column.right_aligned ? " class=\"r\"" : "";
}

}  // namespace

std::string escapeHtml(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string htmlHead(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<title>" + escapeHtml(title) + "</title>\n" + kHead +
         "</head>\n<body>\n<h1>" + escapeHtml(title) + "</h1>\n";
}

std::string htmlTail() {
  return std::string(kScript) + "</body>\n</html>\n";
}

std::string htmlTable(const Table& table) {
  std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const TableColumn& column : table.columns)
    text +=
        std::string("<th") + (column.right_aligned ? " class=\"r\"" : "") + ">" + escapeHtml(column.title) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      text +=
          std::string("<td") + cellClass(table.columns[i]) + ">" + (i < row.size() ? escapeHtml(row[i]) : "") + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (unsigned digit = 0; digit < 4; ++digit)
      text += i + digit <= bytes.size() ? kDigits[three >> (18 - 6 * digit) & 63U] : '=';
  }
  return text;
}

std::string htmlPicture(const std::string& png_path, const std::string& alternative_text) {
  std::ifstream file(png_path, std::ios::binary);
  if (!file) return "";
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return "<img alt=\"" + escapeHtml(alternative_text) + "\" src=\"data:image/png;base64," + base64(bytes.str()) + "\">";
}

}  // namespace epcc
