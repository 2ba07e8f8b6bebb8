#pragma once
/// Pieces of the pages. What is called `text` is escaped, what is called `html` is not.
#include <string>
#include <string_view>
#include <vector>

namespace steradian::books {

/// & < > " as entities.
std::string escaped(std::string_view text);

/// A number as the pages show it, three digits. Throws Error (Other) if it is not finite: no page has holes.
std::string figure(double value);
/// "1.23 M"
std::string rate(double perSecond);
/// "+3.2 %"
std::string percent(double share);

struct Row {
  std::vector<std::string> cells;  ///< HTML
};
std::string table(const std::vector<std::string>& headTexts, const std::vector<Row>& rows);

/// A whole page, with links to the others; nothing is loaded from elsewhere.
std::string page(std::string_view titleText, std::string_view bodyHtml);

}  // namespace steradian::books
