#include "steradian/apps/books/claims.h"

#include <fmt/format.h>

#include "steradian/apps/books/html.h"
#include "steradian/apps/books/trials.h"
#include "steradian/apps/steradian/console.h"

namespace steradian::books {
namespace {

using Words = std::vector<std::string>;

/// What the claims share: the folder of their pictures, and the references.
struct Bench {
  std::filesystem::path folder;
  Effort effort;
  Tally& tally;
  Measurer measurer;

  std::vector<TrialResult> run(const std::vector<Trial>& trials) {
    std::vector<TrialResult> results;
    results.reserve(trials.size());
    for (const Trial& trial : trials) results.push_back(books::run(trial, measurer, effort, folder));
    for (const TrialResult& result : results) add(result);
    return results;
  }
  void add(const TrialResult& result) {
    tally.samples += result.samples;
    tally.nonFinite += result.nonFinite;
  }
};

Words command(const char* scene, const Words& more) {
  Words words{"render", scene, "--size", "256x256", "--spp", "64", "--view", "Book"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string section(const char* id, const char* title, const std::string& html) {
  app::printOut(fmt::format("claim: {}\n", title));
  return fmt::format("<h2 id=\"{}\">{}</h2>\n{}", id, escaped(title), html);
}

/// relMSE, time and efficiency over the first.
std::string comparison(const std::vector<Trial>& trials, const std::vector<TrialResult>& results) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialResult& r = results[i];
    rows.push_back({{trials[i].label, std::to_string(r.samplesPerPixel), figure(r.seconds), figure(r.relMse),
                     figure(r.efficiencyOver(results.front()))}});
  }
  return table({"", "spp", "s", "relMSE", "efficiency"}, rows) + commandsOf(trials);
}

std::string sphereTakesLonger(Bench& bench) {
  const auto mixture = [](const char* target) {
    return command("cornell-glass-sphere", {"--strategy", "mixture", "--target", target});
  };
  const std::vector<Trial> trials{{"the light", mixture("lights")},
                                  {"the sphere", mixture("glass sphere")},
                                  {"both", mixture("lights,glass sphere")}};
  const std::vector<TrialResult> results = bench.run(trials);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    rows.push_back({{trials[i].label, rate(results[i].samplesPerSecond), figure(results[i].raysPerSample),
                     figure(results[i].seconds / results.front().seconds), figure(results[i].relMse)}});
  }
  return "<p>Sampling the sphere took the book (section 12.3) five times as long as sampling the light, probably "
         "because "
         "rays that hit glass are expensive. The same scene with the same number of samples here:</p>\n" +
         table({"target", "samples/s", "rays per sample", "time", "relMSE"}, rows) + commandsOf(trials);
}

std::string mixtureReducesNoise(Bench& bench) {
  const std::vector<Trial> trials{
      {"the cosine alone (Image 9)", command("cornell-box", {"--strategy", "bsdf"})},
      {"the mixture of both (Image 11)", command("cornell-box", {"--strategy", "mixture"})},
      {"a shadow ray, no chance hits", command("cornell-box", {"--strategy", "light"})},
      {"both, by the power heuristic (default)", command("cornell-box", {"--strategy", "mis"})}};
  return "<p>The mixture of light and surface sampling (section 10.3) beside its parts, and beside shadow rays, which "
         "chapter 11 talks about:</p>\n" +
         comparison(trials, bench.run(trials));
}

std::string boxAsTarget(Bench& bench) {
  // The ceiling above the aluminium box, where its mirror casts light.
  const auto ceiling = [](const char* strategy, const char* target) {
    return command("cornell-aluminium", {"--strategy", strategy, "--target", target, "--crop", "60,180,18,60"});
  };
  std::vector<Trial> trials{{"the light (Image 12)", ceiling("mixture", "lights")},
                            {"the light and the box", ceiling("mixture", "lights,tall box")},
                            {"shadow rays, and aiming at the box", ceiling("mis", "tall box")}};
  trials[0].picture = "claim-ceiling-light.png";
  trials[1].picture = "claim-ceiling-box.png";
  const std::string html = comparison(trials, bench.run(trials));
  return "<p>Section 12.3 calls a density for a block quite a bit of work, and leaves the ceiling over the aluminium "
         "box "
         "noisy. Boxes are sampled by their visible faces here; the ceiling alone:</p>\n" +
         html +
         "<div class=\"pair\"><figure><img src=\"claim-ceiling-light.png\" alt=\"the ceiling, aiming at the light\" "
         "style=\"image-rendering: pixelated\"><figcaption>the light as target</figcaption></figure>\n<figure><img "
         "src=\"claim-ceiling-box.png\" alt=\"the ceiling, aiming at light and box\" style=\"image-rendering: "
         "pixelated\"><figcaption>the light and the box</figcaption></figure></div>\n";
}

std::string shadowRays(Bench& bench) {
  std::vector<Trial> trials;
  std::vector<TrialResult> results;
  for (const char* count : {"1", "4", "8", "16"}) {
    trials.push_back({count, command("cornell-box", {"--integrator", std::string("path:light-samples=") + count})});
    results.push_back(results.empty()
                          ? run(trials.back(), bench.measurer, bench.effort, bench.folder)
                          : runFor(results.front().seconds, trials.back(), bench.measurer, bench.effort, bench.folder));
    bench.add(results.back());
  }
  // The commands on the page name the numbers of samples that were taken.
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].command[5] = std::to_string(results[i].samplesPerPixel);
  return "<p>Chapter 11 mentions 1, 4, 8 or 16 shadow rays at each bounce. In the same time, with fewer paths for more "
         "rays:</p>\n" +
         comparison(trials, results);
}

std::string almostMirrors(Bench& bench) {
  const auto fuzzy = [](float fuzz) {
    return [fuzz](SceneDescription& scene) {
      for (MaterialDescription& material : scene.materials)
        if (auto* metal = std::get_if<MetalMaterial>(&material.model)) metal->fuzz = fuzz;
    };
  };
  std::vector<Trial> trials;
  for (const char* strategy : {"mis", "mixture"}) {
    const Words words = command("cornell-aluminium", {"--strategy", strategy});
    trials.push_back({fmt::format("{}, mirror", strategy), words});
    for (const float fuzz : {1e-4f, 1e-3f, 1e-2f})
      trials.push_back({fmt::format("{}, fuzz {:g}", strategy, fuzz), words, fuzzy(fuzz)});
  }
  const std::vector<TrialResult> results = bench.run(trials);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const TrialResult& r = results[i];
    const double mirrors = results[i / 4 * 4].mean;
    rows.push_back({{trials[i].label, rate(r.samplesPerSecond), figure(r.relMse), percent(r.mean / mirrors - 1.0),
                     std::to_string(r.nonFinite)}});
  }
  return "<p>Chapter 11 leaves it open whether mirrors are a special case or surfaces of a roughness too small to be "
         "seen, "
         "which must not make NaN. Both work here: metal of little fuzz in the place of the aluminium box's mirror, "
         "with "
         "relMSE against the mirror's reference and the mean luminance beside the mirror's. With the mixture, metal of "
         "little fuzz wastes on the light every other direction that leaves it; a mirror does not.</p>\n" +
         table({"aluminium", "samples/s", "relMSE", "mean", "not finite"}, rows) + commandsOf(trials);
}

std::string stratification(Bench& bench) {
  std::vector<Trial> trials;
  for (const char* sampler : {"independent", "stratified", "sobol"})
    trials.push_back({sampler, command("cornell-box", {"--sampler", sampler})});
  return "<p>Section 2.3 advises to stratify where there are few dimensions. A pixel with its bounces has many; here "
         "each "
         "pair of them is stratified for itself:</p>\n" +
         comparison(trials, bench.run(trials));
}

std::string mixtureInFog(Bench& bench) {
  const auto mixture = [](const char* weight) {
    return command("cornell-smoke", {"--integrator", std::string("path:strategy=mixture:target-weight=") + weight});
  };
  const std::vector<Trial> trials{
      {"the phase function and surfaces alone", command("cornell-smoke", {"--strategy", "bsdf"})},
      {"a quarter to the light", mixture("0.25")},
      {"half to the light", mixture("0.5")},
      {"three quarters to the light", mixture("0.75")},
      {"shadow rays, by the power heuristic (default)", command("cornell-smoke", {})}};
  return "<p>One weight for every place (section 10.3), also where smoke and fog scatter to all sides:</p>\n" +
         comparison(trials, bench.run(trials));
}

std::string gapAsTarget(Bench& bench) {
  const std::vector<Trial> trials{
      {"shadow rays, no target", command("door-crack", {"--integrator", "path:target-weight=0"})},
      {"the mixture, aiming at the lamp behind the door",
       command("door-crack", {"--strategy", "mixture", "--target", "lights"})},
      {"the mixture, aiming at the gap", command("door-crack", {"--strategy", "mixture", "--target", "gap"})},
      {"shadow rays, and aiming at the gap (default)", command("door-crack", {})}};
  return "<p>Anything may be aimed at that light comes through (chapter 12), not lights alone: a room that is lit "
         "through the gap under its door. Here the gap alone is not enough, for behind it the lamp has still to be "
         "found.</p>\n" +
         comparison(trials, bench.run(trials));
}

/// The rule of three: with none in n, the rate is below 3/n with 95 % confidence.
std::string notANumber(const Tally& tally) {
  const auto samples = static_cast<double>(tally.samples);
  const double perHundredMillion = static_cast<double>(tally.nonFinite) / samples * 1e8;
  std::string text = fmt::format(
      "<p>The book (section 12.6) meets a NaN in every 10 to 100 million rays and makes it black. All pictures of "
      "these "
      "pages together: {} samples (a sample is a path of several rays), {} of them not finite, that is {} in "
      "10<sup>8</sup>",
      figure(samples), tally.nonFinite, figure(perHundredMillion));
  if (tally.nonFinite == 0)
    text += fmt::format("; with 95 % confidence fewer than {} in 10<sup>8</sup>", figure(3.0 / samples * 1e8));
  return text + ".</p>\n";
}

}  // namespace

void writeClaims(const std::filesystem::path& folder, const Effort& effort, Tally tally) {
  Bench bench{folder, effort, tally, Measurer(effort)};
  std::string body = fmt::format(
      "<p>What the books say in passing, measured: {}, {} samples per pixel where nothing else is said; relMSE against "
      "two renders of {} by the default settings, whose noise is subtracted; efficiency is 1 / (relMSE x seconds) over "
      "that of the first row.</p>\n",
      effort.quick ? "48 x 36" : "256 x 256", effort.quick ? 16 : 64, effort.referenceSamples());
  body += section("sphere", "Sampling the sphere takes five times as long", sphereTakesLonger(bench));
  body += section("mixture", "The mixture reduces noise", mixtureReducesNoise(bench));
  body += section("box", "A density for a block is quite a bit of work", boxAsTarget(bench));
  body += section("shadow-rays", "1, 4, 8, 16 shadow rays", shadowRays(bench));
  body += section("mirrors", "Mirrors of a very small roughness", almostMirrors(bench));
  body += section("stratification", "Stratified samples", stratification(bench));
  body += section("fog", "A fixed mixture in fog", mixtureInFog(bench));
  body += section("door", "A gap as target", gapAsTarget(bench));
  body += section("not-a-number", "NaN", notANumber(tally));
  writePage(folder / "claims.html", page("Claims of the books, as figures", body));
}

}  // namespace steradian::books
