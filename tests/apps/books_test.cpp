/// The tables of the books' pictures, and the pieces of their pages.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "steradian/apps/books/html.h"
#include "steradian/apps/books/measurement.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/integrators/make_integrator.h"
#include "steradian/tests/support/statistics.h"

namespace steradian::books {
namespace {

/// The numbers in "Image N: ..." and "Image N, ...".
std::set<int> numbersOf(const std::vector<NumberedPicture>& pictures) {
  std::set<int> numbers;
  for (const NumberedPicture& picture : pictures) numbers.insert(std::stoi(picture.title.substr(6)));
  return numbers;
}

std::set<int> range(int first, int last) {
  std::set<int> numbers;
  for (int i = first; i <= last; ++i) numbers.insert(i);
  return numbers;
}

TEST(Books, EveryNumberedPictureIsThere) {
  EXPECT_EQ(numbersOf(restOfYourLife()), range(1, 15));
  EXPECT_EQ(numbersOf(oneWeekend()), range(4, 23));
}

TEST(Books, EveryPictureHasItsOwnNameAndACommandThatParses) {
  std::set<std::string> names;
  for (const auto* pictures : {&restOfYourLife(), &oneWeekend()}) {
    for (const NumberedPicture& picture : *pictures) {
      SCOPED_TRACE(picture.id);
      EXPECT_TRUE(names.insert(picture.id).second);
      EXPECT_EQ(findPicture(picture.id), &picture);
      EXPECT_FALSE(picture.section.empty());
      EXPECT_EQ(picture.command.front(), "render");
      for (const bool quick : {false, true}) {
        const app::RenderOptions options = optionsOf(picture, Effort{quick});
        EXPECT_EQ(options.scene.name, picture.command[1]);
        ASSERT_TRUE(options.display.has_value());
        EXPECT_NO_THROW(makeIntegrator(options.integrator));
      }
      // A picture that no command can render is biased, and its page says why.
      EXPECT_TRUE(picture.mistake == Mistake::None || !picture.bias.empty());
    }
  }
  EXPECT_EQ(findPicture("rest-of-your-life-16"), nullptr);
}

TEST(Books, CommandsAreWordsOfTheShell) {
  EXPECT_EQ(findPicture("rest-of-your-life-13")->commandLine(),
            "steradian render cornell-glass-sphere --size 256x256 --spp 144 --sampler stratified --integrator "
            "path:roulette-strength=0 --strategy mixture --target \"glass sphere\" --view Book -o "
            "rest-of-your-life-13.png");
  EXPECT_EQ(findPicture("rest-of-your-life-04")->commandLine(), "steradian-books --only rest-of-your-life-04 -o .");
}

TEST(Books, WrongCommandsAreRefused) {
  EXPECT_THROW(parseRender({"render", "cornel-box"}), Error);
  EXPECT_THROW(parseRender({"render", "cornell-box", "--strategy", "guess"}), Error);
  EXPECT_THROW(parseRender({"render"}), Error);
}

TEST(Books, PagesHaveNoHoles) {
  EXPECT_EQ(figure(0.01234), "0.0123");
  EXPECT_EQ(rate(1.5e6), "1.5 M");
  EXPECT_EQ(percent(-0.1234), "-12.3 %");
  EXPECT_THROW(figure(std::numeric_limits<double>::quiet_NaN()), Error);
  EXPECT_THROW(percent(std::numeric_limits<double>::infinity()), Error);
}

TEST(Books, TextIsEscaped) {
  EXPECT_EQ(escaped("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
  EXPECT_NE(page("<b>", "<p>x</p>").find("<h1>&lt;b&gt;</h1>\n<p>x</p>"), std::string::npos);
  EXPECT_NE(table({"a&b"}, {{{"<i>1</i>"}}}).find("<th>a&amp;b</th></tr>\n<tr><td><i>1</i></td>"), std::string::npos);
}

/// One sphere around the camera and everything: light arrives after any number of bounces, so that the weight of a
/// bounce shows. A mistake of w per bounce makes the radiance e / (1 - w a) of e / (1 - a).
double furnace(Mistake mistake, float albedo) {
  SceneDescription d;
  const Id white = d.addMaterial("white", LambertMaterial{d.addColour(grey(albedo))});
  SphereSet set;
  set.add({0.0f, 0.0f, 0.0f}, 1.0f);
  d.setEmission(d.addShape("sphere", set, white), {grey(1.0f), true});
  d.camera = PerspectiveCamera{.lookFrom = {0.0f, 0.0f, 0.0f}};
  d.defaults.maxDepth = 60;
  const Scene scene(std::move(d));
  const RenderSettings settings{.width = 16, .height = 16, .samplesPerPixel = 64};
  return meanLuminance(render(scene, BookIntegrator(mistake), settings).film.image()).mean;
}

TEST(Books, TheWrongDenominatorWeighsABounceByFourThirds) {
  EXPECT_NEAR(furnace(Mistake::None, 0.5f), 2.0, 1e-4);
  EXPECT_NEAR(furnace(Mistake::UniformDenominator, 0.45f), 1.0 / (1.0 - 0.45 * 4.0 / 3.0), 0.02);
}

TEST(Books, GlassThatAlwaysRefractsIsInvisibleWithIndexOne) {
  const auto mean = [](Mistake mistake, float eta) {
    SceneDescription d;
    SphereSet set;
    set.add({0.0f, 0.0f, -2.0f}, 0.5f);
    d.addShape("sphere", set, d.addMaterial("glass", DielectricMaterial{.eta = eta}));
    d.addLight("sky", GradientSky{.nadir = {0.0f, 0.0f, 0.0f}, .zenith = {1.0f, 1.0f, 1.0f}});
    d.camera = PerspectiveCamera{.lookFrom = {0.0f, 0.0f, 0.0f}};
    const Scene scene(std::move(d));
    const RenderSettings settings{.width = 16, .height = 16, .samplesPerPixel = 64};
    const Image image = render(scene, BookIntegrator(mistake), settings).film.image();
    return image.at(8, 6, image.channel("G"));
  };
  EXPECT_NEAR(mean(Mistake::AlwaysRefracts, 1.0f), mean(Mistake::None, 1.0f), 1e-4f);
  // Above its middle a glass ball shows what is below: without reflection, darker than with it.
  EXPECT_LT(mean(Mistake::AlwaysRefracts, 1.5f), mean(Mistake::None, 1.5f) - 0.005f);
}

// The default settings against themselves: a ratio near 1, and no bias beyond noise.
TEST(Books, MeasuresTheDefaultSettingsAsGoodAsThemselves) {
  app::RenderOptions options =
      parseRender({"render", "cornell-box", "--size", "32x32", "--spp", "64", "--replicates", "8"});
  Measurer measurer(Effort{true});
  const Scene scene(std::move(options.scene));
  const Measurement m = measurer.measure(renderScene(scene, std::move(options)), "cornell-box");
  EXPECT_GT(m.relMse, 0.0);
  EXPECT_GT(test::zTestPValue(m.bias, m.biasError, 0.0, 0.02), test::suiteLevel());
}

// Without indirect light a fifth of the light is missing, far more than noise.
TEST(Books, MeasuresBias) {
  Measurer measurer(Effort{true});
  const auto measured = [&](const char* integrator) {
    app::RenderOptions options =
        parseRender({"render", "cornell-box", "--size", "32x32", "--spp", "64", "--integrator", integrator});
    const Scene scene(std::move(options.scene));
    return measurer.measure(renderScene(scene, std::move(options)), "cornell-box");
  };
  const Measurement light = measured("path:strategy=mixture:target-weight=1"), chance = measured("path:strategy=bsdf");
  EXPECT_GT(light.bias, -0.3);
  EXPECT_LT(light.bias, -0.15);
  EXPECT_LT(light.biasError, 0.03);
  EXPECT_GT(chance.biasError, light.biasError);
  // A hundred times the error: no change of the machine's speed outweighs that.
  ASSERT_TRUE(chance.ratio.has_value());
  EXPECT_LT(*chance.ratio, 0.5);
}

}  // namespace
}  // namespace steradian::books
