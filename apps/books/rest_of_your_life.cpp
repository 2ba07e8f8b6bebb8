/// "The Rest of Your Life" v4. The book renders at 600 x 600 with 1000 samples per pixel where no other number is said;
/// we take less.
#include "steradian/apps/books/picture.h"

namespace steradian::books {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kNoIndirect =
    "all directions lead to the light, so that light from anywhere else is lost, but for what a ray finds where it is "
    "stopped on its way";
constexpr const char* kWeightOne = "path:target-weight=1:roulette-strength=0";
constexpr const char* kPlain = "path:roulette-strength=0";
constexpr const char* kCosine = "path:scatter-pdf=cosine:roulette-strength=0";

/// Without roulette and with the stratified sampler, as the book is from its second chapter on.
Words command(const char* scene, const char* samples, const char* integrator, const char* strategy,
              const Words& more = {}) {
  Words words{"render",    scene,        "--size",       "256x256",  "--spp",      samples,
              "--sampler", "stratified", "--integrator", integrator, "--strategy", strategy};
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), {"--view", "Book"});
  return words;
}

std::vector<NumberedPicture> firstHalf() {
  Words independent = command("cornell-original", "64", kPlain, "bsdf");
  independent[7] = "independent";
  return {
      {"rest-of-your-life-01", "Image 1: the Cornell box, not stratified", "2.3", independent,
       "Rays scatter as the material says and find the light by chance."},
      {"rest-of-your-life-02", "Image 2: stratified", "2.3", command("cornell-original", "64", kPlain, "bsdf"),
       "The book stratifies the position in the pixel; the sampler here every pair of dimensions, those of the bounces "
       "among them."},
      {"rest-of-your-life-03", "Image 3: more samples", "6.1", command("cornell-original", "144", kPlain, "bsdf"),
       "The picture that the next chapters set out to make less noisy."},
      {"rest-of-your-life-04", "Image 4: an imperfect density, as printed", "6.2",
       command("cornell-original", "144", kPlain, "bsdf"),
       "Listing 20 divides by 1/2&pi; what is still drawn with the density cos/&pi;. A bounce then weighs 2 cos in "
       "place "
       "of 1, that is 4/3 on average: white walls of 0.73 reflect 0.97.",
       Mistake::UniformDenominator, "samples are divided by a density that they do not have"},
      {"rest-of-your-life-04-right", "Image 4, put right", "6.2",
       command("cornell-original", "144", "path:scatter-pdf=hemisphere:roulette-strength=0", "bsdf"),
       "What the chapter says: directions drawn with the density 1/2&pi; and divided by it. The same picture as Image "
       "3, "
       "with more noise."},
      {"rest-of-your-life-05", "Image 5: scattering evenly into the hemisphere", "6.3",
       command("cornell-uniform-diffuse", "144", kPlain, "bsdf"),
       "Another material is another picture. It is measured against its own reference."},
      {"rest-of-your-life-06", "Image 6: directions about the normal, by an orthonormal basis", "8.3",
       command("cornell-original", "144", kPlain, "bsdf"), "The estimator of Image 3, written in another way."},
      {"rest-of-your-life-07", "Image 7: sampling the light alone", "9.2",
       command("cornell-original", "10", kWeightOne, "mixture"),
       "10 samples. The light has two sides: the ceiling just above it is lit as well. (By solid angle, as quads are "
       "sampled here, it is less noisy there than in the book.)",
       Mistake::None, kNoIndirect},
  };
}

std::vector<NumberedPicture> secondHalf() {
  return {
      {"rest-of-your-life-08", "Image 8: a light that faces down", "9.3",
       command("cornell-box", "10", kWeightOne, "mixture"), "10 samples. The same with a light of one side.",
       Mistake::None, kNoIndirect},
      {"rest-of-your-life-09", "Image 9: the cosine density as a class", "10.1",
       command("cornell-box", "144", kCosine, "bsdf"), "Light is found by chance again."},
      {"rest-of-your-life-10", "Image 10: sampling a hittable, the light", "10.2",
       command("cornell-box", "10", kWeightOne, "mixture", {"--target", "light"}),
       "10 samples. Image 8, with the light as a sampling target that has a name.", Mistake::None, kNoIndirect},
      {"rest-of-your-life-11", "Image 11: the mixture of cosine and light", "10.3",
       command("cornell-box", "144", kCosine, "mixture"),
       "Half of the directions lead to the light, half follow the cosine; all are divided by the density of the "
       "mixture."},
      {"rest-of-your-life-12", "Image 12: densities from the materials, an aluminium box", "12.2",
       command("cornell-aluminium", "144", kPlain, "mixture"),
       "The mirror sends light to the ceiling, where nothing but chance looks for it. <a href=\"claims.html#box\">With "
       "the box as a target</a> that noise falls."},
      {"rest-of-your-life-13", "Image 13: a glass sphere, and only the sphere sampled", "12.3",
       command("cornell-glass-sphere", "144", kPlain, "mixture", {"--target", "glass sphere"}),
       "The caustic is good and the room is noisy. Listing 55 still names the light; the text says the sphere."},
      {"rest-of-your-life-14", "Image 14: sampling the sphere and the light", "12.5",
       command("cornell-glass-sphere", "144", kPlain, "mixture", {"--target", "lights,glass sphere"}),
       "A list of targets has the mean of their densities. The book's picture has black specks; ours has none."},
      {"rest-of-your-life-15", "Image 15: without NaN", "12.6",
       command("cornell-glass-sphere", "196", kPlain, "mixture", {"--target", "lights,glass sphere"}),
       "The book sets what is not a number to 0. Here such samples are dropped, counted and reported."},
  };
}

}  // namespace

const std::vector<NumberedPicture>& restOfYourLife() {
  static const std::vector<NumberedPicture> all = [] {
    std::vector<NumberedPicture> pictures = firstHalf();
    for (NumberedPicture& picture : secondHalf()) pictures.push_back(std::move(picture));
    return pictures;
  }();
  return all;
}

}  // namespace steradian::books
