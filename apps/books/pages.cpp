#include "steradian/apps/books/pages.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "steradian/apps/books/html.h"
#include "steradian/apps/books/measurement.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/core/base/atomic_file.h"

namespace steradian::books {
namespace {

constexpr const char* kRestOfYourLife =
    "<p>The fifteen numbered pictures of \"Ray Tracing: The Rest of Your Life\" (v4), each by the estimator of its "
    "chapter and with the command that renders it. <em>relMSE</em> is the squared error relative to a reference, the "
    "mean of two renders of the same scene by the default settings ({0} samples per pixel together); its own noise is "
    "subtracted. <em>Ratio</em> compares with the default settings (multiple importance sampling, Sobol' points, "
    "roulette) in the same time: efficiency, 1 / (relMSE x seconds), over theirs; below 1 the default settings are "
    "better. Where a chapter's estimator does not converge to the picture of its scene it is marked as biased, with "
    "the difference of the mean luminance and its standard error. {1} threads.</p>\n";

constexpr const char* kInOneWeekend =
    "<p>The numbered pictures of \"Ray Tracing in One Weekend\" (v4) from the first with normals on, each with its "
    "command. Up to Image 11 the book writes linear values, from Image 12 on their square roots.</p>\n";

struct Shown {
  const NumberedPicture* picture;
  Rendering rendering;
  std::optional<Measurement> measured;
};

std::string sizeText(const Rendering& rendering) {
  const RenderSettings& s = rendering.options.settings;
  return fmt::format("{} x {}, {} spp", *s.width, *s.height, *s.samplesPerPixel);
}

std::string ratioText(const Measurement& m) { return m.ratio ? figure(*m.ratio) : "below the reference's noise"; }

std::string biasText(const Measurement& m) {
  figure(m.bias + m.biasError);
  return fmt::format("{:+.1f} &plusmn; {:.1f} %", 100.0 * m.bias, 100.0 * m.biasError);
}

std::string figuresText(const Shown& shown) {
  std::string text = fmt::format("{}; {} s, {}samples/s", sizeText(shown.rendering), figure(shown.rendering.seconds()),
                                 rate(shown.rendering.samplesPerSecond()));
  if (shown.measured) {
    text += fmt::format("; relMSE {} (default settings in this time: {}), ratio {}", figure(shown.measured->relMse),
                        figure(shown.measured->defaultRelMse), ratioText(*shown.measured));
  }
  return text + fmt::format("; non-finite samples: {}", shown.rendering.statistics.nonFiniteSamples);
}

std::string card(const Shown& shown) {
  const NumberedPicture& picture = *shown.picture;
  std::string html = fmt::format("<div class=\"card\" id=\"{}\">\n<img src=\"{}\" alt=\"{}\"{}>\n<div>\n<h3>{}</h3>\n",
                                 picture.id, picture.file(), escaped(picture.title),
                                 picture.enlarged ? " class=\"enlarged\"" : "", escaped(picture.title));
  html += fmt::format("<div>Section {}. {}</div>\n", escaped(picture.section), picture.note);
  if (!picture.bias.empty()) {
    const std::string size = shown.measured ? " " + biasText(*shown.measured) : "";
    html += fmt::format("<div class=\"biased\">Biased{}: {}.</div>\n", size, escaped(picture.bias));
  }
  html += fmt::format("<pre>{}</pre>\n<div class=\"figures\">{}</div>\n</div>\n</div>\n",
                      escaped(picture.commandLine()), figuresText(shown));
  return html;
}

std::string summary(const std::vector<Shown>& all) {
  std::vector<Row> rows;
  for (const Shown& shown : all) {
    const NumberedPicture& picture = *shown.picture;
    rows.push_back({{fmt::format("<a href=\"#{}\">{}</a>", picture.id, escaped(picture.title)),
                     escaped(picture.section), rate(shown.rendering.samplesPerSecond()), figure(shown.measured->relMse),
                     ratioText(*shown.measured), picture.bias.empty() ? "" : biasText(*shown.measured)}});
  }
  return table({"picture", "section", "samples/s", "relMSE", "ratio", "bias"}, rows);
}

Shown show(const NumberedPicture& picture, const std::filesystem::path& folder, const Effort& effort) {
  Shown shown{&picture, renderPicture(picture, effort), std::nullopt};
  writePicture(shown.rendering, folder / picture.file());
  return shown;
}

}  // namespace

void writePage(const std::filesystem::path& path, const std::string& html) {
  writeFileAtomically(path, std::as_bytes(std::span(html)));
  app::printOut(path.string() + "\n");
}

void writeRestOfYourLife(const std::filesystem::path& folder, const Effort& effort, Tally& tally) {
  Measurer measurer(effort);
  std::vector<Shown> all;
  for (const NumberedPicture& picture : restOfYourLife()) {
    Shown shown = show(picture, folder, effort);
    shown.measured = measurer.measure(shown.rendering, picture.command[1]);
    app::printOut(fmt::format("{}: {} s, relMSE {}, ratio {}, mean {}\n", picture.id, figure(shown.rendering.seconds()),
                              figure(shown.measured->relMse), ratioText(*shown.measured),
                              percent(shown.measured->bias)));
    tally.add(shown.rendering);
    shown.rendering.image = Image(1, 1, {"Y"});  // written already
    all.push_back(std::move(shown));
  }
  std::string body =
      fmt::format(kRestOfYourLife, 2 * effort.referenceSamples(), tbb::this_task_arena::max_concurrency());
  body += summary(all);
  for (const Shown& shown : all) body += card(shown);
  writePage(folder / "rest-of-your-life.html", page("The Rest of Your Life, picture by picture", body));
}

void writeInOneWeekend(const std::filesystem::path& folder, const Effort& effort, Tally& tally) {
  std::string body = kInOneWeekend;
  for (const NumberedPicture& picture : oneWeekend()) {
    const Shown shown = show(picture, folder, effort);
    app::printOut(fmt::format("{}: {} s\n", picture.id, figure(shown.rendering.seconds())));
    tally.add(shown.rendering);
    body += card(shown);
  }
  writePage(folder / "in-one-weekend.html", page("In One Weekend, picture by picture", body));
}

}  // namespace steradian::books
