#include "steradian/apps/books/html.h"

#include <fmt/format.h>

#include <cmath>

#include "steradian/core/base/diagnostics.h"

namespace steradian::books {
namespace {

constexpr std::string_view kStyle = R"css(
body { margin: 2em auto; max-width: 68em; padding: 0 1em; font: 15px/1.5 system-ui, sans-serif; color: #222; }
h1 { font-size: 1.7em; } h2 { font-size: 1.25em; margin-top: 2em; } h3 { font-size: 1.05em; margin: 0 0 .4em; }
nav a { margin-right: 1.5em; } a { color: #0b5394; }
table { border-collapse: collapse; margin: .8em 0; }
th, td { padding: .2em .8em; border-bottom: 1px solid #ddd; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
code, pre { font: 13px/1.4 ui-monospace, monospace; }
pre { background: #f4f4f2; padding: .5em .7em; white-space: pre-wrap; overflow-wrap: anywhere; margin: .5em 0; }
.card { display: flex; gap: 1.4em; margin: 1.6em 0; align-items: flex-start; }
.card img { flex: none; width: 320px; height: auto; background: #eee; }
.card img.enlarged { image-rendering: pixelated; }
.card > div { min-width: 0; }
.biased { color: #a61c00; font-weight: 600; }
.figures { color: #444; margin: .3em 0; }
.pair { display: flex; gap: 1em; } .pair figure { margin: 0; } .pair img { width: 320px; height: auto; }
@media (max-width: 48em) { .card { flex-direction: column; } }
)css";

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string figure(double value) {
  if (!std::isfinite(value)) throw Error(ErrorKind::Other, "a figure of the pages is not a number");
  return fmt::format("{:.3g}", value);
}

std::string rate(double perSecond) { return figure(perSecond / 1e6) + " M"; }

std::string percent(double share) {
  figure(share);
  return fmt::format("{:+.1f} %", 100.0 * share);
}

std::string table(const std::vector<std::string>& headTexts, const std::vector<Row>& rows) {
  std::string html = "<table>\n<tr>";
  for (const std::string& text : headTexts) html += "<th>" + escaped(text) + "</th>";
  html += "</tr>\n";
  for (const Row& row : rows) {
    html += "<tr>";
    for (const std::string& cell : row.cells) html += "<td>" + cell + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string page(std::string_view titleText, std::string_view bodyHtml) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n"
      "<body>\n<nav><a href=\"in-one-weekend.html\">In One Weekend</a>"
      "<a href=\"rest-of-your-life.html\">The Rest of Your Life</a><a href=\"claims.html\">Claims</a></nav>\n"
      "<h1>{0}</h1>\n{2}</body>\n</html>\n",
      escaped(titleText), kStyle, bodyHtml);
}

}  // namespace steradian::books
