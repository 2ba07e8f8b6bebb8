#include "steradian/materials/model_parameters.h"

#include <gtest/gtest.h>

#include <set>

#include "steradian/materials/bsdf.h"
#include "steradian/tests/materials/models.h"

namespace steradian {
namespace {

static_assert(kParameterCount<Absorber<float>> == 0);
static_assert(kParameterCount<Lambert<float>> == 3);
static_assert(kParameterCount<Dielectric<float>> == 1);
static_assert(kParameterCount<Coated<float>> == 5);

struct WithFlag {
  float eta;
  bool flag;
};
struct WithNumber {
  float eta;
  std::uint32_t number;
};
struct Many {
  Spectrum<float> reflectance;
  float others[17];
};
template <class Model>
constexpr bool isMadeOf() {
  return detail::isMadeOfFloats<Model>(std::make_index_sequence<sizeof(Model) / sizeof(float)>{});
}
static_assert(!isMadeOf<WithFlag>());
static_assert(!isMadeOf<WithNumber>());
static_assert(isMadeOf<Many>());
static_assert(kParameterCount<Many> == 20);

TEST(ModelParameters, MakeTheSameModelAgain) {
  test::forEachModel([](const std::string& name, const auto& model, const auto& wide) {
    using Model = std::decay_t<decltype(model)>;
    const auto parameters = parametersOf(model);
    const auto parameter = [&](auto i) { return parameters[i]; };
    const auto again = makeModel<Model, kParameterCount<Model>>(parameter);
    EXPECT_EQ(parametersOf(again), parameters) << name;

    using Wide = std::decay_t<decltype(wide)>;
    const Vec3f wo = test::fromNormal(40.0);
    const auto lanes = makeModel<Wide, kParameterCount<Model>>([&](auto i) { return Lanes<8>(parameters[i]); });
    const Spectrum<Lanes<8>> albedo = lanes.albedo(broadcast<Lanes<8>>(wo));
    EXPECT_EQ(lane(albedo, 3).g, model.albedo(wo).g) << name;
  });
}

/// Every model of the list passes through all tests.
TEST(ModelParameters, EveryModelOfTheListIsTested) {
  std::set<std::size_t> tested;
  test::forEachModel(
      [&](const std::string&, const auto& model, const auto&) { tested.insert(Bsdf::Model(model).index()); });
  EXPECT_EQ(tested.size(), std::variant_size_v<Bsdf::Model>);
}

}  // namespace
}  // namespace steradian
