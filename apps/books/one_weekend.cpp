/// "In One Weekend" v4, from the first picture with normals on.
#include "steradian/apps/books/picture.h"

namespace steradian::books {
namespace {

using Words = std::vector<std::string>;

/// The scene of picture N, at 400 x 225.
Words scene(int number, const char* samples, const char* view, const Words& more = {}) {
  Words words{"render", "one-weekend-picture:" + std::to_string(number), "--spp", samples, "--view", view};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string id(const char* number) { return std::string("in-one-weekend-") + number; }

// Before chapter 9.5 the book writes linear values into its files.
constexpr const char* kLinear = "Raw";
constexpr const char* kGamma = "Book";

std::vector<NumberedPicture> normalsAndDiffuse() {
  const Words normals{"--integrator", "normals"};
  const Words before{"--integrator", "normals", "--crop", "110,174,50,86", "--filter", "box:0.01"};
  const Words after{"--integrator", "normals", "--crop", "110,174,50,86"};
  return {
      {id("04"), "Image 4: a sphere coloured by its normals", "6.1", scene(4, "16", kLinear, normals), ""},
      {id("05"), "Image 5: with a ground", "6.7", scene(5, "16", kLinear, normals), ""},
      {id("06-before"), "Image 6: before antialiasing", "8.2", scene(6, "1", kLinear, before),
       "One ray through the middle of each pixel; some of them, enlarged.", Mistake::None, "", true},
      {id("06-after"), "Image 6: and after", "8.2", scene(6, "100", kLinear, after), "100 rays, anywhere in the pixel.",
       Mistake::None, "", true},
      {id("07"), "Image 7: a diffuse sphere", "9.1", scene(7, "100", kLinear, {"--max-depth", "100000"}),
       "Uniform scattering into the hemisphere, without a limit to the number of bounces. There is no acne here: rays "
       "start outside of the error of the point that they leave."},
      {id("08"), "Image 8: a limited number of bounces", "9.2", scene(8, "100", kLinear),
       "50 rays, that is 49 bounces."},
      {id("09"), "Image 9: no shadow acne", "9.3", scene(9, "100", kLinear), "The picture of Images 7 and 8 here."},
      {id("10"), "Image 10: Lambert", "9.4", scene(10, "100", kLinear),
       "More light goes to the normal: shadows are darker, and the sky tints the spheres."},
      {id("11"), "Image 11: the gamut, linear", "9.5", scene(11, "100", kLinear),
       "The book pastes five renders together; here five spheres, each on a strip of ground like itself, reflect a "
       "tenth, three, five, seven and nine tenths."},
      {id("12"), "Image 12: with gamma 2", "9.5", scene(12, "100", kGamma), "The same numbers in the view Book."},
  };
}

std::vector<NumberedPicture> metalAndGlass() {
  return {
      {id("13"), "Image 13: metal", "10.5", scene(13, "100", kGamma), ""},
      {id("14"), "Image 14: fuzz of 0.3 and 1", "10.6", scene(14, "100", kGamma),
       "Fuzzy metal has a density in closed form here (<code>materials/fuzzy_metal.h</code>)."},
      {id("15"), "Image 15: glass", "11.1", scene(15, "100", kGamma),
       "The book shows a wrong render, and not its program. This is the scene, right."},
      {id("16"), "Image 16: glass that always refracts", "11.2", scene(16, "100", kGamma),
       "Without Fresnel's reflection, as printed.", Mistake::AlwaysRefracts, "glass reflects nothing"},
      {id("17"), "Image 17: an air bubble in water", "11.3", scene(17, "100", kGamma),
       "It reflects where it cannot refract, and nowhere else yet.", Mistake::AlwaysRefracts,
       "the interface reflects only what it must"},
      {id("18"), "Image 18: a hollow glass sphere", "11.5", scene(18, "100", kGamma),
       "Schlick's reflectance from here on."},
  };
}

std::vector<NumberedPicture> cameraAndFinal() {
  return {
      {id("19"), "Image 19: a wide angle", "12.1", scene(19, "100", kGamma), "90 degrees from top to bottom."},
      {id("20"), "Image 20: from farther away", "12.2", scene(20, "100", kGamma), ""},
      {id("21"), "Image 21: 20 degrees", "12.2", scene(21, "100", kGamma), ""},
      {id("22"), "Image 22: defocus blur", "13.2", scene(22, "100", kGamma), "A lens of 10 degrees, in focus at 3.4."},
      {id("23"), "Image 23: the cover", "14.1", scene(23, "64", kGamma, {"--size", "800x450"}),
       "484 spheres, of which the random numbers are ours."},
  };
}

}  // namespace

const std::vector<NumberedPicture>& oneWeekend() {
  static const std::vector<NumberedPicture> all = [] {
    std::vector<NumberedPicture> pictures = normalsAndDiffuse();
    for (NumberedPicture& picture : metalAndGlass()) pictures.push_back(std::move(picture));
    for (NumberedPicture& picture : cameraAndFinal()) pictures.push_back(std::move(picture));
    return pictures;
  }();
  return all;
}

}  // namespace steradian::books
