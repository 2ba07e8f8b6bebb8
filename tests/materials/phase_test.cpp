#include "steradian/materials/phase.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

const Vec3f kWo = normalize(Vec3f{0.3f, -0.5f, 0.2f});

TEST(Phase, ScattersAboutTheWayOfTheLight) {
  const Phase<float> forward{0.9f};
  const float ahead = forward.eval(kWo, -kWo, Transport::Radiance).pdf;
  // (1 - g^2) / (4 pi (1 -+ g)^3)
  EXPECT_NEAR(ahead / (0.19 / (12.566370614 * 0.001)), 1.0, 1e-4);
  EXPECT_NEAR(forward.eval(kWo, kWo, Transport::Radiance).pdf / (0.19 / (12.566370614 * 6.859)), 1.0, 1e-4);
}

TEST(Phase, SamplesHaveTheValueOfEvalAndItIsReciprocal) {
  for (const float g : {-0.7f, 0.0f, 0.4f, 0.95f}) {
    const Phase<float> phase{g};
    const auto us = test::unitNumbers(200, 1), vs = test::unitNumbers(200, 2);
    for (std::size_t i = 0; i < us.size(); ++i) {
      const BsdfSample<float> s = phase.sample(kWo, {0.5f, {us[i], vs[i]}}, Transport::Radiance);
      const BsdfValue<float> f = phase.eval(kWo, s.wi, Transport::Radiance);
      EXPECT_NEAR(f.pdf / s.pdf, 1.0, 2e-4) << g;
      EXPECT_EQ(f.value.g, f.pdf);
      EXPECT_EQ(s.weight.g, 1.0f);
      EXPECT_NEAR(phase.eval(s.wi, kWo, Transport::Radiance).pdf / f.pdf, 1.0, 2e-4);
    }
  }
}

}  // namespace
}  // namespace steradian
